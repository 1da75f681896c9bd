#include <gtest/gtest.h>

#include <cmath>

#include "body/operator.hpp"
#include "solids.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Vec2;
using base::Vector;
using body::Drive;
using body::NonlinearBody;
using support::fixed_edge;
using support::metal;
using support::moved;
using support::rubber;

/// A block on a foot, its right side moved and turned as a rigid line.
body::BodyInput bent(const material::Material& m, Analysis analysis, bool cure) {
  auto in = support::elastic(1.0, 0.0, analysis);
  in.material = m;
  in.kinematics = base::Kinematics::finite;
  in.b_bar = cure;
  body::Support grip;
  grip.name = "grip";
  grip.edge = "right";
  grip.rigid = true;
  const bool ring = analysis == Analysis::axisymmetric;
  grip.x = moved(0.3);
  grip.y = moved(-0.2);
  grip.rotation = ring ? body::Motion{} : moved(0.25);
  in.supports = {grip, fixed_edge("foot", "bottom")};
  in.supports[1].x.drive = Drive::free;
  in.contact_boundaries = {"top"};
  return in;
}

struct Case {
  material::Material material;
  Analysis analysis;
  bool cure;
};

class renewed_reference : public testing::TestWithParam<Case> {};

// A state in equilibrium must be in equilibrium, with the same reactions, when its shape has become the reference; and
// a motion on from there must end where it would have ended.
TEST_P(renewed_reference, stays_in_equilibrium) {
  const auto [material, analysis, cure] = GetParam();
  const auto mesh = support::rectangle({.corner = {3, 0}, .size = {3, 2}, .nx = 6, .ny = 5, .distortion = 0.5});
  auto in = bent(material, analysis, cure);
  const NonlinearBody b(body::make_shape(mesh), in);
  const auto s = support::solve_nonlinear(b, in, 4);

  auto current = mesh;
  const auto u = b.recover(s.q, s.state.y);
  for (int k = 0; k < mesh.node_count(); ++k) current.X[k] += u[k];
  const NonlinearBody renewed(body::make_shape(current), in);
  auto start = renewed.start();
  start.history = s.state.history;
  start.F0 = b.deformation(s.state, s.q);
  const Vector q = Vector::Zero(renewed.dofs());
  NonlinearBody::Linearised lin;
  renewed.linearise(start, start.y, q, {}, lin);
  EXPECT_LT(lin.interior_residual, 1e-10 * lin.force_scale);
  const Vector r = b.retained_residual(s.state, s.state.y, s.q, {});
  EXPECT_LT((renewed.retained_residual(start, start.y, q, {}) - r).cwiseAbs().maxCoeff(), 1e-10 * lin.force_scale);
  EXPECT_EQ(renewed.accepted(start, start.y, q).F0, start.F0);

  auto further = in;
  for (auto* motion : {&further.supports[0].x, &further.supports[0].y, &further.supports[0].rotation})
    for (auto& part : motion->parts) part.value *= 1.2;
  // From the accepted state, one increment to 1.2: on the old mesh in total motions, on the renewed one in the rest.
  const auto increment = [](const NonlinearBody& body, const body::Interior& before, Vector at_q,
                            const body::BodyInput& to, double counted) {
    NonlinearBody::Linearised at;
    body::Interior now = before;
    for (int iteration = 0; iteration < 12; ++iteration) {
      body.linearise(before, now.y, at_q, {}, at);
      Vector rhs = -at.r;
      for (const auto& c : body.support_columns()) {
        const auto& m = support::motion_of(to, c);
        if (m.drive == Drive::free) continue;
        at.S.row(c.column).setZero();
        at.S(c.column, c.column) = 1.0;
        rhs[c.column] = support::total(m) * counted - at_q[c.column];  // zero where fixed
      }
      const Vector dq = algebra::solve_dense(at.S, rhs);
      now.y += body.interior_step(at, dq);
      at_q += dq;
    }
    return body.recover(at_q, now.y);
  };
  const auto whole = increment(b, s.state, s.q, further, 1.0);
  const auto rest = increment(renewed, start, q, further, 0.2 / 1.2);
  for (int k = 0; k < mesh.node_count(); ++k) EXPECT_LT((mesh.X[k] + whole[k] - current.X[k] - rest[k]).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    all, renewed_reference,
    testing::Values(Case{rubber, Analysis::plane_strain, true}, Case{rubber, Analysis::plane_stress, false},
                    Case{rubber, Analysis::axisymmetric, true}, Case{metal, Analysis::plane_strain, true},
                    Case{metal, Analysis::plane_strain, false}, Case{metal, Analysis::axisymmetric, true}));

}  // namespace
