#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "fem/element.hpp"
#include "fem/stiffness.hpp"
#include "material/stress.hpp"
#include "steel.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Points;
using base::Vec2;
using fem_tests::Steel;
using fem_tests::steel;
using mesh::CellKind;

Vec2 linear(const Vec2& x) { return {0.01 * x[0] - 0.02 * x[1], 0.005 * x[0] + 0.03 * x[1]}; }
Vec2 waves(const Vec2& x) {
  return {0.01 * std::sin(2.0 * x[0]) * std::cos(x[1]), 0.01 * std::cos(x[0]) * std::sin(2.0 * x[1])};
}

Points at_nodes(const mesh::Mesh& m, Vec2 (*u)(const Vec2&)) {
  Points values;
  for (const auto& x : m.X) values.push_back(u(x));
  return values;
}

double relative(const mesh::Mesh& m, Analysis analysis, Vec2 (*u)(const Vec2&)) {
  const auto error = fem::recovered_error(m, steel, analysis, false, at_nodes(m, u));
  return std::sqrt(error.difference / error.energy);
}

/// Strain of `waves` in the order (11, 22, gamma_12, 33).
Eigen::Vector4d strain(const Vec2& x) {
  return {0.02 * std::cos(2.0 * x[0]) * std::cos(x[1]), 0.02 * std::cos(x[0]) * std::cos(2.0 * x[1]),
          -0.01 * std::sin(2.0 * x[0]) * std::sin(x[1]) - 0.01 * std::sin(x[0]) * std::sin(2.0 * x[1]), 0.0};
}

/// Relative error in the energy norm of the interpolated `waves`, by midpoints of four by four
/// parts of each cell, quads.
double exact(const mesh::Mesh& m, Analysis analysis) {
  const Eigen::Matrix4d C = material::tangent(steel, analysis);
  const auto u = at_nodes(m, waves);
  double difference = 0.0, energy = 0.0;
  for (const auto& cell : m.cells)
    for (int p = 0; p < 16; ++p) {
      const Vec2 xi(-0.75 + 0.5 * (p % 4), -0.75 + 0.5 * (p / 4));
      const auto N = mesh::shape_functions(m.kind, xi);
      const auto dN = mesh::shape_gradients(m.kind, xi);
      Vec2 x = Vec2::Zero();
      Eigen::Matrix2d J = Eigen::Matrix2d::Zero(), H = Eigen::Matrix2d::Zero();
      for (int a = 0; a < mesh::nodes_per_cell(m.kind); ++a) {
        x += N[a] * m.X[cell[a]];
        J += m.X[cell[a]] * dN.row(a);
        H += u[cell[a]] * dN.row(a);
      }
      const Eigen::Matrix2d G = H * J.inverse();
      const Eigen::Vector4d e = strain(x), wrong = Eigen::Vector4d(G(0, 0), G(1, 1), G(0, 1) + G(1, 0), 0.0) - e;
      difference += J.determinant() * wrong.dot(C * wrong);
      energy += J.determinant() * e.dot(C * e);
    }
  return std::sqrt(difference / energy);
}

mesh::Mesh square(CellKind kind, int n, double distortion = 0.0) {
  return support::rectangle({.nx = n, .ny = n, .kind = kind, .distortion = distortion});
}

}  // namespace

// A uniform stress is recovered as it is: no error, on any elements, in any idealisation that keeps it uniform.
TEST(RecoveredError, UniformStress) {
  for (const auto kind : {CellKind::tri3, CellKind::quad4, CellKind::tri6, CellKind::quad8})
    for (const auto analysis : {Analysis::plane_strain, Analysis::plane_stress})
      EXPECT_LT(relative(square(kind, 4, 0.5), analysis, linear), 1e-12);
}

// The energy of a uniform stress must be that of its strain, int eps : C : eps.
TEST(RecoveredError, Energy) {
  const double trace = 0.01 + 0.03, shear = -0.02 + 0.005;
  const double expected =
      Steel::lambda * trace * trace + 2 * Steel::mu * (0.01 * 0.01 + 0.03 * 0.03) + Steel::mu * shear * shear;
  const auto m = square(CellKind::quad4, 3, 0.5);
  const auto found = fem::recovered_error(m, steel, Analysis::plane_strain, false, at_nodes(m, linear));
  EXPECT_NEAR(found.energy, expected, 1e-12 * expected);
}

// Of a smooth field on quads the estimate must fall at first order and be the true error within 15 %.
TEST(RecoveredError, RateAndSize) {
  for (const auto analysis : {Analysis::plane_strain, Analysis::plane_stress}) {
    std::vector<double> estimates;
    for (int n : {8, 16, 32}) {
      const auto m = square(CellKind::quad4, n);
      estimates.push_back(relative(m, analysis, waves));
      EXPECT_NEAR(estimates.back() / exact(m, analysis), 1.0, 0.15) << n;
    }
    for (int k : {0, 1}) EXPECT_NEAR(std::log2(estimates[k] / estimates[k + 1]), 1.0, 0.15);
  }
}
