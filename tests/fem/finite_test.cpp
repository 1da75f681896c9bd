#include "fem/finite.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"
#include "fem/assemble_loads.hpp"
#include "finite_support.hpp"
#include "material/finite.hpp"

namespace {

using namespace reye;
using namespace reye::fem_tests;
using material::Gradient;

class solid : public testing::TestWithParam<Case> {
 protected:
  const Case& param() const { return GetParam(); }
  const fem::Solid& of() const { return GetParam().solid; }
  bool finite() const { return of().kinematics == Kinematics::finite; }

  Vector force(const Mesh& mesh, const Vector& u) const {
    fem::InternalForce f;
    fem::internal_force(mesh, of(), u, fem::virgin(mesh, of()), f);
    return f.total;
  }
};

// Central differences of the internal force must approach the tangent at rate 2.
TEST_P(solid, tangent_is_the_derivative) {
  const auto mesh = patch_mesh(param().kind);
  const Vector u = bent(mesh);
  const Vector along = nodal(mesh, [](const Vec2& X) {
    return Vec2{std::sin(5 * X.x() + X.y()), std::cos(3 * X.y() * X.x())};
  });
  const auto K = support::tangent(mesh, of(), u, fem::virgin(mesh, of()), fem::Pattern(mesh));
  const Vector exact = K * along;
  const auto error = [&](double h) {
    return ((force(mesh, u + h * along) - force(mesh, u - h * along)) / (2 * h) - exact).norm() / exact.norm();
  };
  const double coarse = error(4e-4), fine = error(1e-4);
  if (finite() || of().has_history()) {
    EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 1.8) << coarse << " " << fine;
  }
  EXPECT_LT(fine, 1e-4);
  if (of().symmetric(param().kind)) {
    EXPECT_LT((K - base::SparseMatrix(K.transpose())).norm(), 1e-12 * K.norm());
  }
}

// The tangent of all cells must be that of half of them and of the others, which meanwhile were made at another state;
// cells that are left out add nothing.
TEST_P(solid, tangent_is_the_sum_of_its_cells) {
  const auto mesh = patch_mesh(param().kind);
  const Vector u = bent(mesh), other = 0.5 * u;
  const fem::Pattern pattern(mesh);
  const auto virgin = fem::virgin(mesh, of());
  std::vector<char> even(mesh.cells.size()), odd(mesh.cells.size());
  for (std::size_t cell = 0; cell < even.size(); ++cell) odd[cell] = !(even[cell] = cell % 2 == 0);
  const auto whole = support::tangent(mesh, of(), u, virgin, pattern);
  base::Matrix of_cells = fem::cell_tangents(mesh);
  fem::renew(mesh, of(), u, virgin, even, of_cells);
  fem::renew(mesh, of(), other, virgin, odd, of_cells);
  auto of_even = pattern.zero(), of_odd = pattern.zero();
  fem::assemble(mesh, of_cells, even, pattern, of_even);
  fem::renew(mesh, of(), u, virgin, odd, of_cells);
  fem::assemble(mesh, of_cells, odd, pattern, of_odd);
  EXPECT_LT((of_even + of_odd - whole).norm(), 1e-14 * whole.norm());
}

// A uniform deformation must be in balance with its tractions at every node, and be recovered as stress at the nodes.
TEST_P(solid, uniform_state_is_in_balance) {
  const auto mesh = patch_mesh(param().kind);
  const auto H = uniform_gradient(of().analysis);
  const Vector u = nodal(mesh, [&](const Vec2& X) { return Vec2(H * X); });
  const bool ring = of().analysis == Analysis::axisymmetric;
  Gradient<double> P;
  fem::Stress sigma;
  if (finite()) {
    const Gradient<double> F{1 + H(0, 0), H(0, 1), H(1, 0), 1 + H(1, 1), ring ? 1 + H(0, 0) : 1.0};
    P = material::first_piola(of().material, of().analysis, F);
    sigma = material::kirchhoff(of().material, of().analysis, F);
    const double J = material::plane_determinant(F) * material::thickness_stretch(of().material, of().analysis, F);
    for (double& s : sigma) s /= J;
  } else {
    const double hoop = ring ? H(0, 0) : 0.0;
    sigma = material::stress(of().material, of().analysis,
                             material::Voigt<double>{H(0, 0), H(1, 1), H(0, 1) + H(1, 0), hoop});
    P = {sigma[0], sigma[2], sigma[2], sigma[1], sigma[3]};
  }
  Vector tractions = Vector::Zero(u.size());
  for (const auto& [name, boundary] : mesh.boundaries) {
    const auto& chain = boundary.front();
    const Vec2 n = base::right_of((mesh.X[chain.back()] - mesh.X[chain.front()]).normalized());
    const Vec2 t{P[0] * n.x() + P[1] * n.y(), P[2] * n.x() + P[3] * n.y()};
    tractions += fem::load_vector(mesh, of().analysis, {name, name, 0.0, t, {}, ""});
  }
  EXPECT_LT((force(mesh, u) - tractions).norm(), 1e-10 * tractions.norm());

  const auto history = fem::updated(mesh, of(), u, fem::virgin(mesh, of()));
  const auto state = fem::nodal_state(mesh, of(), u, history);
  for (const auto& s : state.stress)
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(s[i], sigma[i], 1e-9 * (std::abs(sigma[0]) + std::abs(sigma[1])));
  const double plastic = of().has_history() ? history[0].accumulated : 0.0;
  for (double p : state.plastic_strain) EXPECT_NEAR(p, plastic, 1e-10);
}

// After a plastic step its own history must give the same force again: the state is on the yield surface.
TEST_P(solid, history_reproduces_the_force) {
  const auto mesh = patch_mesh(param().kind);
  const Vector u = bent(mesh);
  const auto history = fem::updated(mesh, of(), u, fem::virgin(mesh, of()));
  EXPECT_EQ(history.empty(), !of().has_history());
  fem::InternalForce again;
  fem::internal_force(mesh, of(), u, history, again);
  const Vector first = force(mesh, u);
  EXPECT_LT((again.total - first).norm(), 1e-9 * first.norm());
  for (const auto& state : history) EXPECT_GT(state.accumulated, 0.0);
}

// A rigid rotation by 60 degrees must cost nothing, and turn the forces of a deformed state with the body.
TEST_P(solid, forces_turn_with_the_body) {
  if (!finite() || of().analysis == Analysis::axisymmetric) return;
  const auto mesh = patch_mesh(param().kind);
  const double angle = std::acos(0.5);
  const Eigen::Matrix2d R{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
  const auto turn = [&](const Vector& u) {
    Vector v(u.size());
    for (int k = 0; k < mesh.node_count(); ++k) v.segment<2>(2 * k) = R * (mesh.X[k] + u.segment<2>(2 * k)) - mesh.X[k];
    return v;
  };
  EXPECT_LT(force(mesh, turn(Vector::Zero(2 * mesh.node_count()))).norm(), 1e-10 * 300.0);
  const Vector u = bent(mesh), f = force(mesh, u), turned = force(mesh, turn(u));
  for (int k = 0; k < mesh.node_count(); ++k)
    EXPECT_LT((turned.segment<2>(2 * k) - R * f.segment<2>(2 * k)).norm(), 1e-10 * f.norm());
}

INSTANTIATE_TEST_SUITE_P(all, solid, testing::ValuesIn(all_cases()));

// A deformation that turns a cell inside out must be a SolveError that names the cell, the point and its place.
TEST(solid_errors, name_the_gauss_point) {
  for (bool cure : {true, false}) {
    const auto mesh = support::rectangle({.size = {2, 1}, .nx = 2, .ny = 1});
    Vector u = Vector::Zero(2 * mesh.node_count());
    u[2 * 2] = -1.8;  // the lower right corner crosses the second cell
    fem::InternalForce f;
    try {
      fem::internal_force(mesh, {rubber, Analysis::plane_strain, Kinematics::finite, cure}, u, {}, f);
      FAIL() << "no error";
    } catch (const base::SolveError& error) {
      EXPECT_NE(std::string(error.what()).find("cell 1, Gauss point "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(" mm: "), std::string::npos) << error.what();
    }
  }
}

}  // namespace
