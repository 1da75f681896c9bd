#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "fem/assemble_loads.hpp"
#include "finite_support.hpp"
#include "material/finite.hpp"

namespace {

using namespace reye;
using namespace reye::fem_tests;
using fem::GaussState;
using fem::Prestrain;
using material::Gradient;

std::vector<Case> finite_cases() {
  auto cases = all_cases();
  std::erase_if(cases, [](const Case& c) { return c.solid.kinematics == Kinematics::small; });
  return cases;
}

Mesh moved(Mesh mesh, const Vector& u) {
  for (int k = 0; k < mesh.node_count(); ++k) mesh.X[k] += u.segment<2>(2 * k);
  return mesh;
}

/// A second deformation, on top of `bent`.
Vector more(const Mesh& mesh) {
  return nodal(mesh, [](const Vec2& x) {
    return Vec2{-0.05 * x.x() + 0.04 * std::sin(2 * x.y() - x.x()), 0.07 * x.y() + 0.05 * std::cos(x.x() + x.y())};
  });
}

class prestrain : public testing::TestWithParam<Case> {
 protected:
  const fem::Solid& of() const { return GetParam().solid; }
  Mesh mesh_ = patch_mesh(GetParam().kind);

  Vector force(const Mesh& mesh, const Vector& u, const GaussState& before) const {
    fem::InternalForce f;
    fem::internal_force(mesh, of(), u, before, f);
    return f.total;
  }

  base::SparseMatrix tangent(const Mesh& mesh, const Vector& u, const GaussState& before) const {
    return support::tangent(mesh, of(), u, before, fem::Pattern(mesh));
  }
};

// An F0 of one must change no bit of force, tangent, history and stress.
TEST_P(prestrain, identity_changes_nothing) {
  const Vector u = bent(mesh_);
  const auto history = fem::virgin(mesh_, of());
  const Prestrain one(mesh_.cells.size() * fem::stiffness_rule(mesh_.kind).size(), {1.0, 0.0, 0.0, 1.0, 1.0});
  EXPECT_EQ(force(mesh_, u, {history, one}), force(mesh_, u, history));
  EXPECT_EQ((tangent(mesh_, u, {history, one}) - tangent(mesh_, u, history)).norm(), 0.0);
  const auto with = fem::updated(mesh_, of(), u, {history, one}), without = fem::updated(mesh_, of(), u, history);
  ASSERT_EQ(with.size(), without.size());
  for (size_t i = 0; i < with.size(); ++i) EXPECT_EQ(with[i].strain, without[i].strain);
  EXPECT_EQ(fem::nodal_state(mesh_, of(), u, {with, one}).stress, fem::nodal_state(mesh_, of(), u, without).stress);
}

// When the current shape becomes X, every nodal force, nodal stress and history must stay as they are, and develop as
// they would have.
TEST_P(prestrain, renewed_reference_goes_on) {
  const Vector u = bent(mesh_), du = more(mesh_);
  const auto history = fem::updated(mesh_, of(), u, fem::virgin(mesh_, of()));
  const Mesh renewed = moved(mesh_, u);
  const Prestrain F0 = fem::deformation(mesh_, of(), u, {});
  for (const Vector& rest : {Vector(0.0 * du), du}) {
    const Vector f = force(mesh_, u + rest, history);
    EXPECT_LT((force(renewed, rest, {history, F0}) - f).norm(), 1e-12 * f.norm());
    const auto after = fem::updated(mesh_, of(), u + rest, history);
    const auto again = fem::updated(renewed, of(), rest, {history, F0});
    for (size_t i = 0; i < after.size(); ++i) {
      EXPECT_NEAR(after[i].accumulated, again[i].accumulated, 1e-12);
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(after[i].strain[k], again[i].strain[k], 1e-12);
    }
    // On a ring det F at the centre is not the growth of the cell: cells weigh a little otherwise at a node.
    if (of().analysis == Analysis::axisymmetric && of().cure) continue;
    const auto sigma = fem::nodal_state(mesh_, of(), u + rest, after).stress;
    const auto sigma_again = fem::nodal_state(renewed, of(), rest, {after, F0}).stress;
    for (size_t k = 0; k < sigma.size(); ++k)
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(sigma[k][i], sigma_again[k][i], 1e-11 * 300.0);
  }
  const Prestrain whole = fem::deformation(mesh_, of(), u + du, {});
  const Prestrain in_two = fem::deformation(renewed, of(), du, F0);
  for (size_t i = 0; i < whole.size(); ++i)
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(whole[i][k], in_two[i][k], 1e-12);
}

// A uniform deformation in one go, or partly as F0 on another mesh of the deformed shape, must give the same stress and
// the forces of its tractions at every node.
TEST_P(prestrain, uniform_deformation_on_a_fresh_mesh) {
  const auto H = uniform_gradient(of().analysis);
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity(), first = one + 0.6 * H, rest = (one + H) * first.inverse();
  const bool ring = of().analysis == Analysis::axisymmetric;
  const Vector u = nodal(mesh_, [&](const Vec2& X) { return Vec2(H * X); });
  Mesh fresh =
      support::rectangle({.corner = {4, 1}, .size = {3, 2}, .nx = 3, .ny = 5, .kind = mesh_.kind, .distortion = 0.3});
  fresh = moved(fresh, nodal(fresh, [&](const Vec2& X) { return Vec2((first - one) * X); }));
  const Prestrain F0(fresh.cells.size() * fem::stiffness_rule(fresh.kind).size(),
                     {first(0, 0), first(0, 1), first(1, 0), first(1, 1), ring ? first(0, 0) : 1.0});
  const Vector v = nodal(fresh, [&](const Vec2& X) { return Vec2((rest - one) * X); });

  const auto history = fem::updated(mesh_, of(), u, fem::virgin(mesh_, of()));
  const auto again = fem::updated(fresh, of(), v, {fem::virgin(fresh, of()), F0});
  const auto sigma = fem::nodal_state(mesh_, of(), u, history).stress.front();
  for (const auto& s : fem::nodal_state(fresh, of(), v, {again, F0}).stress)
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(s[i], sigma[i], 1e-12 * 300.0);

  // P on the fresh X is that of the whole deformation, pushed by `first`.
  const double J = first.determinant() * (ring ? first(0, 0) : 1.0);
  const Gradient<double> F{1 + H(0, 0), H(0, 1), H(1, 0), 1 + H(1, 1), ring ? 1 + H(0, 0) : 1.0};
  const auto P = material::first_piola(of().material, of().analysis, F);
  const Eigen::Matrix2d P_X = Eigen::Matrix2d{{P[0], P[1]}, {P[2], P[3]}} * first.transpose() / J;
  Vector tractions = Vector::Zero(v.size());
  for (const auto& [name, boundary] : fresh.boundaries) {
    const auto& chain = boundary.front();
    const Vec2 n = base::right_of((fresh.X[chain.back()] - fresh.X[chain.front()]).normalized());
    tractions += fem::load_vector(fresh, of().analysis, {name, name, 0.0, P_X * n, {}, ""});
  }
  EXPECT_LT((force(fresh, v, {fem::virgin(fresh, of()), F0}) - tractions).norm(), 1e-12 * tractions.norm());
}

// Central differences of the internal force must approach the tangent at rate 2, whatever F0 is.
TEST_P(prestrain, tangent_is_the_derivative) {
  const Mesh renewed = moved(mesh_, bent(mesh_));
  auto uncured = of();
  uncured.cure = false;  // det F0 differs within the cell
  const Prestrain F0 = fem::deformation(mesh_, uncured, bent(mesh_), {});
  const auto history = fem::virgin(mesh_, of());
  const Vector u = more(renewed);
  const Vector along = nodal(mesh_, [](const Vec2& X) {
    return Vec2{std::sin(5 * X.x() + X.y()), std::cos(3 * X.y() * X.x())};
  });
  const Vector exact = tangent(renewed, u, {history, F0}) * along;
  const auto error = [&](double h) {
    const Vector rise = force(renewed, u + h * along, {history, F0}) - force(renewed, u - h * along, {history, F0});
    return (rise / (2 * h) - exact).norm() / exact.norm();
  };
  const double coarse = error(4e-4), fine = error(1e-4);
  EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 1.8) << coarse << " " << fine;
  EXPECT_LT(fine, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(all, prestrain, testing::ValuesIn(finite_cases()));

}  // namespace
