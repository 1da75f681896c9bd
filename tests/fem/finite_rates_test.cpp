#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "base/dual.hpp"
#include "fem/element.hpp"
#include "finite_support.hpp"
#include "material/finite.hpp"

namespace {

using namespace reye;
using namespace reye::fem_tests;
using base::Dual;

/// The manufactured displacement, some 10 % of the body, and its gradient.
template <class T>
material::Gradient<T> manufactured_F(Analysis analysis, const T& X, const T& Y) {
  using std::cos, std::sin;
  const T R = X;
  const T u1 = 0.08 * sin(2.0 * X) * cos(1.5 * Y);
  material::Gradient<T> F{1.0 + 0.16 * cos(2.0 * X) * cos(1.5 * Y), -0.12 * sin(2.0 * X) * sin(1.5 * Y),
                          -0.1 * sin(X) * sin(2.0 * Y), 1.0 + 0.2 * cos(X) * cos(2.0 * Y), T(1.0)};
  if (analysis == Analysis::axisymmetric) F[4] = 1.0 + u1 / R;
  return F;
}

Vec2 manufactured_u(const Vec2& X) {
  return {0.08 * std::sin(2 * X.x()) * std::cos(1.5 * X.y()), 0.1 * std::cos(X.x()) * std::sin(2 * X.y())};
}

/// b = -Div P by dual numbers.
Vec2 body_force(const fem::Solid& solid, const Vec2& X) {
  using D = Dual<2>;
  const D x = D::variable(X.x(), 0), y = D::variable(X.y(), 1);
  const auto P = material::first_piola(solid.material, solid.analysis, manufactured_F(solid.analysis, x, y));
  Vec2 b{-P[0].d[0] - P[1].d[1], -P[2].d[0] - P[3].d[1]};
  if (solid.analysis == Analysis::axisymmetric) b -= Vec2{P[0].v - P[4].v, P[2].v} / X.x();
  return b;
}

struct Errors {
  double l2 = 0.0, h1 = 0.0;
};

/// Positions and displacements of a cell, entries beyond its nodes zero.
struct CellFields {
  Eigen::Matrix<double, mesh::most_cell_nodes, 2> X = Eigen::Matrix<double, mesh::most_cell_nodes, 2>::Zero();
  Eigen::Matrix<double, mesh::most_cell_nodes, 2> u = Eigen::Matrix<double, mesh::most_cell_nodes, 2>::Zero();

  CellFields(const Mesh& mesh, int cell, const Vector& nodal_u) {
    for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) {
      X.row(a) = mesh.X[mesh.cells[cell][a]];
      u.row(a) = nodal_u.segment<2>(2 * mesh.cells[cell][a]);
    }
  }
};

/// Calls visit(cell fields, N, dN/dX, volume, X) at the points of `volume_rule`.
template <class Visit>
void for_each_point(const Mesh& mesh, Analysis analysis, const Vector& u, Visit visit) {
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellFields c(mesh, cell, u);
    for (const auto& at : fem::volume_rule(mesh.kind)) {
      const auto N = fem::shape_functions(mesh.kind, at.xi);
      const auto dN = fem::shape_gradients(mesh.kind, at.xi);
      const Eigen::Matrix2d J = dN.transpose() * c.X;
      const Vec2 X = c.X.transpose() * N;
      const double volume = at.weight * J.determinant() * base::out_of_plane(analysis, X.x());
      visit(cell, c, N, (dN * J.inverse().transpose()).eval(), volume, X);
    }
  }
}

Errors manufactured_errors(const Case& c, int n) {
  const auto mesh =
      support::mapped(support::rectangle({.corner = {1, 0}, .nx = n, .ny = n, .kind = c.kind}), [](const Vec2& X) {
        return Vec2{X.x() + 0.04 * std::sin(3 * X.y()) * std::sin(3 * X.x()),
                    X.y() + 0.04 * std::sin(2 * X.x() + X.y())};
      });
  Vector f = Vector::Zero(2 * mesh.node_count()), u = nodal(mesh, manufactured_u);
  for_each_point(mesh, c.solid.analysis, u,
                 [&](int cell, const auto&, const auto& N, const auto&, double volume, const Vec2& X) {
                   const Vec2 b = body_force(c.solid, X);
                   for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a)
                     f.segment<2>(2 * mesh.cells[cell][a]) += volume * N[a] * b;
                 });
  const auto table = newton(mesh, c.solid, outline_nodes(mesh), f, u);
  EXPECT_LT(table.back(), 1e-11);
  Errors e;
  for_each_point(mesh, c.solid.analysis, u,
                 [&](int, const CellFields& cell, const auto& N, const auto& dN, double volume, const Vec2& X) {
                   e.l2 += volume * (cell.u.transpose() * N - manufactured_u(X)).squaredNorm();
                   const auto F = manufactured_F(c.solid.analysis, X.x(), X.y());
                   const Eigen::Matrix2d H = cell.u.transpose() * dN, exact{{F[0] - 1, F[1]}, {F[2], F[3] - 1}};
                   e.h1 += volume * (H - exact).squaredNorm();
                 });
  return {std::sqrt(e.l2), std::sqrt(e.h1)};
}

class manufactured : public testing::TestWithParam<Case> {};

// A manufactured displacement of some 10 % must be met at the order of the element: h^(p+1) in L2, h^p in H1.
TEST_P(manufactured, errors_fall_at_the_order_of_the_element) {
  const int order = mesh::order(GetParam().kind), n = order == 1 ? 16 : 8;
  const Errors coarse = manufactured_errors(GetParam(), n), fine = manufactured_errors(GetParam(), 2 * n);
  EXPECT_GT(std::log2(coarse.l2 / fine.l2), order + 1 - 0.2) << coarse.l2 << " " << fine.l2;
  EXPECT_GT(std::log2(coarse.h1 / fine.h1), order - 0.15) << coarse.h1 << " " << fine.h1;
  EXPECT_LT(fine.l2, 3e-4);
}

std::vector<Case> elastic_cases() {
  std::vector<Case> cases;
  for (const auto& c : all_cases())
    if (c.solid.kinematics == Kinematics::finite && !c.solid.has_history()) cases.push_back(c);
  return cases;
}

INSTANTIATE_TEST_SUITE_P(all, manufactured, testing::ValuesIn(elastic_cases()));

// Newton must end quadratically, F-bar and plasticity included.
TEST(solid_newton, ends_quadratically) {
  for (const auto& m : {rubber, metal}) {
    const fem::Solid solid{m, Analysis::plane_strain, Kinematics::finite, true};
    const auto mesh = support::rectangle({.nx = 6, .ny = 6, .distortion = 0.4});
    Vector u = nodal(mesh, [](const Vec2& X) { return Vec2{0.1 * X.x() * X.y(), -0.1 * X.y() * X.y()}; });
    const auto table = newton(mesh, solid, outline_nodes(mesh), Vector::Zero(u.size()), u);
    ASSERT_LT(table.back(), 1e-11);
    // The last step whose end is above round-off: its exponent.
    const size_t k = table.size() - 2;
    EXPECT_LT(table[k], 20 * std::pow(table[k - 1], 1.8)) << table[k - 1] << " " << table[k] << " " << table.back();
    EXPECT_LE(table.size(), 8u);
  }
}

}  // namespace
