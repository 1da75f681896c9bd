#include "fem/element.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Vec2;
using mesh::CellKind;

// Shape functions must sum to one, their gradients to zero, and each be one at its own node only.
TEST(element, partition_of_unity) {
  for (auto kind : {CellKind::tri3, CellKind::quad4, CellKind::tri6, CellKind::quad8}) {
    const Vec2 xi{0.21, 0.37};
    EXPECT_NEAR(fem::shape_functions(kind, xi).sum(), 1.0, 1e-15);
    EXPECT_LT(fem::shape_gradients(kind, xi).colwise().sum().norm(), 1e-15);
  }
  const Vec2 corner[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int a = 0; a < 4; ++a)
    EXPECT_LT((fem::shape_functions(CellKind::quad4, corner[a]) - fem::NodeValues::Unit(a)).norm(), 1e-15);
}

// Gradients must be the derivatives of the shape functions.
TEST(element, gradients_match_differences) {
  for (auto kind : {CellKind::tri3, CellKind::quad4, CellKind::tri6, CellKind::quad8})
    for (int i = 0; i < 2; ++i) {
      const Vec2 xi{0.21, 0.37}, step = 1e-5 * Vec2::Unit(i);
      const fem::NodeValues d = (fem::shape_functions(kind, xi + step) - fem::shape_functions(kind, xi - step)) / 2e-5;
      EXPECT_LT((d - fem::shape_gradients(kind, xi).col(i)).norm(), 1e-10);
    }
}

// Each rule must integrate all monomials up to its degree exactly.
TEST(element, quadrature_is_exact_to_its_degree) {
  const auto integral = [](auto rule, int i, int j) {
    double sum = 0.0;
    for (const auto& p : rule) sum += p.weight * std::pow(p.xi.x(), i) * std::pow(p.xi.y(), j);
    return sum;
  };
  struct Rule {
    CellKind kind;
    std::span<const fem::CellPoint> points;
    int degree;
  };
  for (const Rule& rule : {Rule{CellKind::tri3, fem::stiffness_rule(CellKind::tri3), 1},
                           Rule{CellKind::tri3, fem::volume_rule(CellKind::tri3), 2},
                           Rule{CellKind::tri6, fem::stiffness_rule(CellKind::tri6), 2},
                           Rule{CellKind::tri6, fem::volume_rule(CellKind::tri6), 5},
                           Rule{CellKind::quad4, fem::stiffness_rule(CellKind::quad4), 3},
                           Rule{CellKind::quad4, fem::volume_rule(CellKind::quad4), 3},
                           Rule{CellKind::quad8, fem::stiffness_rule(CellKind::quad8), 3},
                           Rule{CellKind::quad8, fem::volume_rule(CellKind::quad8), 5}})
    for (int i = 0; i <= rule.degree; ++i)
      for (int j = 0; j <= rule.degree; ++j) {
        const auto one = [](int k) { return k % 2 ? 0.0 : 2.0 / (k + 1); };
        const double factorials = std::tgamma(i + 1) * std::tgamma(j + 1) / std::tgamma(i + j + 3);
        if (mesh::corners(rule.kind) == 4) {
          EXPECT_NEAR(integral(rule.points, i, j), one(i) * one(j), 1e-14);
        } else if (i + j <= rule.degree) {
          EXPECT_NEAR(integral(rule.points, i, j), factorials, 1e-15);
        }
      }
}

// The volumes of all points must add up to the volume of the body, the ring by Pappus's theorem.
TEST(element, volumes_add_up) {
  for (auto kind : {CellKind::tri3, CellKind::quad4, CellKind::tri6, CellKind::quad8}) {
    const auto m = support::rectangle({.corner = {2, 1}, .size = {3, 2}, .kind = kind, .distortion = 0.7});
    double area = 0.0, ring = 0.0;
    for (int cell = 0; cell < m.cell_count(); ++cell) {
      for (const auto& p : fem::volume_points(m, cell, Analysis::plane_strain)) area += p.volume;
      for (const auto& p : fem::volume_points(m, cell, Analysis::axisymmetric)) ring += p.volume;
    }
    EXPECT_NEAR(area, 6.0, 1e-13);
    EXPECT_NEAR(ring, 2 * std::numbers::pi * 3.5 * 6.0, 1e-11);
  }
}

// B-bar must leave the deviatoric part alone and make the volumetric part equal at all points of a cell.
TEST(element, b_bar_averages_the_volumetric_part) {
  const auto m = support::rectangle({.corner = {1, 0}, .distortion = 0.8});
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric}) {
    const auto plain = fem::strain_points<4>(m, 5, analysis, false),
               barred = fem::strain_points<4>(m, 5, analysis, true);
    using Row = Eigen::Matrix<double, 1, 8>;
    const auto volumetric = [](const auto& p) -> Row { return p.B.row(0) + p.B.row(1) + p.B.row(3); };
    for (int g = 0; g < 4; ++g) {
      EXPECT_LT((volumetric(barred.points[g]) - volumetric(barred.points[0])).norm(), 1e-13);
      const Row change = volumetric(barred.points[g]) - volumetric(plain.points[g]);
      for (int row : {0, 1, 3})
        EXPECT_LT((barred.points[g].B.row(row) - plain.points[g].B.row(row) - change / 3.0).norm(), 1e-13);
      EXPECT_EQ((barred.points[g].B.row(2) - plain.points[g].B.row(2)).norm(), 0.0);
    }
  }
}

// An inverted cell must be named.
TEST(element, inverted_cell_is_a_mesh_error) {
  auto m = support::rectangle({.nx = 2, .ny = 2});
  std::swap(m.cells[3][0], m.cells[3][1]);
  EXPECT_THROW(fem::strain_points<4>(m, 3, Analysis::plane_strain, true), base::MeshError);
}

}  // namespace
