#include <gtest/gtest.h>

#include "adapt/fields.hpp"
#include "adapt/transfer/gauss_transfer.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using adapt::GaussTransfer;
using base::Analysis;
using base::Kinematics;
using base::Vec2;
using base::Vector;
using body::NonlinearBody;

constexpr std::array all_analyses{Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress};
constexpr std::array strains{Kinematics::small, Kinematics::finite};

body::BodyInput metal(Analysis analysis, Kinematics kinematics) {
  auto in = support::elastic(1.0, 0.0, analysis);
  in.material = material::HenckyJ2{300.0, 0.3, material::LinearHardening{2.0, 30.0}};
  in.kinematics = kinematics;
  return in;
}

double largest_difference(const std::vector<material::PlasticState>& a, const std::vector<material::PlasticState>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i].accumulated - b[i].accumulated));
    for (int k = 0; k < 4; ++k) most = std::max(most, std::abs(a[i].strain[k] - b[i].strain[k]));
  }
  return most;
}

/// A free body whose nodes take the displacements u: its state from virgin.
struct Seated {
  body::Interior state;
  Vector q;

  template <class Displacement>
  Seated(const NonlinearBody& b, const mesh::Mesh& mesh, Displacement u) : state(b.start()), q(Vector::Zero(b.dofs())) {
    base::Points nodal;
    for (const Vec2& X : mesh.X) nodal.push_back(u(X));
    b.seat(nodal, q, state.y);
  }
};

}  // namespace

// Carried onto its own mesh by the nearest points, a state that has flowed unevenly must come back to round-off.
TEST(CarriedState, Identity) {
  const auto mesh = support::rectangle({.corner = {3, 0}, .size = {3, 2}, .nx = 7, .ny = 5, .distortion = 0.5});
  const auto bent = [](const Vec2& X) { return Vec2(0.03 * X.y() * X.y(), 0.02 * X.x() * X.y() - 0.01 * X.x()); };
  for (auto analysis : all_analyses)
    for (auto kinematics : strains) {
      const NonlinearBody b(body::make_shape(mesh), metal(analysis, kinematics));
      const Seated at(b, mesh, bent);
      const auto now = b.accepted(at.state, at.state.y, at.q);
      const auto carried =
          adapt::transfer_elastic(mesh, b.elastic_states(now, at.q), mesh, {GaussTransfer::nearest, analysis});
      EXPECT_LT(largest_difference(b.compatible(now, at.q, carried), now.history), 1e-13);
    }
}

// A homogeneous state must arrive on another mesh of the body as it is there, by every choice, and in equilibrium.
TEST(CarriedState, Homogeneous) {
  const auto from = support::rectangle({.corner = {3, 0}, .size = {3, 2}, .nx = 7, .ny = 5, .distortion = 0.6});
  const auto to = support::rectangle({.corner = {3, 0}, .size = {3, 2}, .nx = 5, .ny = 8, .distortion = 0.4});
  for (auto analysis : all_analyses)
    for (auto kinematics : strains)
      for (auto way : support::transfer_ways) {
        const bool ring = analysis == Analysis::axisymmetric;
        const auto affine = [&](const Vec2& X) {
          return ring ? Vec2(0.1 * X.x(), -0.25 * X.y()) : Vec2(0.2 * X.x() + 0.1 * X.y(), 0.05 * X.x() - 0.15 * X.y());
        };
        const auto in = metal(analysis, kinematics);
        const NonlinearBody old(body::make_shape(from), in), fresh(body::make_shape(to), in);
        const Seated before(old, from, affine), there(fresh, to, affine);
        const auto now = old.accepted(before.state, before.state.y, before.q);
        const auto exact = fresh.accepted(there.state, there.state.y, there.q).history;
        ASSERT_GT(exact[0].accumulated, 0.1);
        const auto carried = adapt::transfer_elastic(from, old.elastic_states(now, before.q), to, {way, analysis});
        EXPECT_LT(largest_difference(fresh.compatible(there.state, there.q, carried), exact), 1e-12);
      }
}
