#include <gtest/gtest.h>

#include <cmath>

#include "fem/stiffness.hpp"
#include "membrane.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Vec2;
using body::Drive;
using mesh::CellKind;
using support::fixed_edge;

struct Tube {
  static constexpr double E = 1000.0, inner = 1.0, outer = 2.0, pressure = 10.0;  ///< MPa and mm
};

body::Support roller(const std::string& edge, bool along_x) {
  auto s = fixed_edge(edge, edge);
  (along_x ? s.x : s.y).drive = Drive::free;
  return s;
}

/// Lame, plane strain: u_r = (1 + nu)/E * p a^2/(b^2 - a^2) * ((1 - 2 nu) r + b^2/r).
double lame(double nu, double r) {
  constexpr double a2 = Tube::inner * Tube::inner, b2 = Tube::outer * Tube::outer;
  const double c = (1 + nu) / Tube::E * Tube::pressure * a2 / (b2 - a2);
  return c * ((1 - 2 * nu) * r + b2 / r);
}

/// Largest relative error of the radial displacement at all nodes.
double ring_error(CellKind kind, double nu, bool b_bar, int n) {
  const auto m =
      support::ring({.inner = Tube::inner, .outer = Tube::outer, .across = n, .around = 2 * n, .kind = kind});
  auto in = support::elastic(Tube::E, nu);
  in.b_bar = b_bar;
  in.supports = {roller("bottom", true), roller("top", false)};
  in.boundary_loads = {{"p", "left", Tube::pressure, {0, 0}, {}, ""}};
  const body::LinearBody b(body::make_shape(m), in);
  const auto s = support::solve_linear(b, in);
  const auto u = b.recover(s.q, s.factors);
  double error = 0.0;
  for (int k = 0; k < m.node_count(); ++k)
    error = std::max(error, std::abs(u[k].dot(m.X[k].normalized()) - lame(nu, m.X[k].norm())));
  return error / lame(nu, Tube::inner);
}

double tube_error(CellKind kind, double nu, int n) {
  const auto m = support::rectangle(
      {.corner = {Tube::inner, 0}, .size = {Tube::outer - Tube::inner, 0.5}, .nx = n, .ny = 2, .kind = kind});
  auto in = support::elastic(Tube::E, nu, Analysis::axisymmetric);
  in.supports = {roller("bottom", true), roller("top", true)};
  in.boundary_loads = {{"p", "left", Tube::pressure, {0, 0}, {}, ""}};
  const body::LinearBody b(body::make_shape(m), in);
  const auto s = support::solve_linear(b, in);
  const auto u = b.recover(s.q, s.factors);
  double error = 0.0;
  for (int k = 0; k < m.node_count(); ++k) error = std::max(error, std::abs(u[k].x() - lame(nu, m.X[k].x())));
  return error / lame(nu, Tube::inner);
}

// The thick cylinder in plane strain must converge to Lame's solution at rate 2.
TEST(elasticity, ring_converges_at_rate_two) {
  for (auto kind : {CellKind::tri3, CellKind::quad4})
    for (bool b_bar : {false, true}) {
      const double coarse = ring_error(kind, 0.3, b_bar, 8), fine = ring_error(kind, 0.3, b_bar, 16);
      EXPECT_LT(fine, 2e-2);
      EXPECT_GT(std::log2(coarse / fine), 1.8) << coarse << " " << fine;
    }
}

// The pressurised cylinder as an axisymmetric rectangle must converge at rate 2.
TEST(elasticity, tube_converges_at_rate_two) {
  for (auto kind : {CellKind::tri3, CellKind::quad4}) {
    const double coarse = tube_error(kind, 0.3, 8), fine = tube_error(kind, 0.3, 16);
    EXPECT_LT(fine, 1e-2);
    EXPECT_GT(std::log2(coarse / fine), 1.8) << coarse << " " << fine;
  }
}

// Close to incompressibility B-bar must keep its accuracy in both idealisations.
TEST(elasticity, b_bar_keeps_its_rate_when_nearly_incompressible) {
  const double coarse = ring_error(CellKind::quad4, 0.49999, true, 8),
               fine = ring_error(CellKind::quad4, 0.49999, true, 16);
  EXPECT_LT(fine, 2e-2);
  EXPECT_GT(std::log2(coarse / fine), 1.8);
  EXPECT_LT(tube_error(CellKind::quad4, 0.49999, 16), 1e-2);
}

/// Vertical displacement of the upper corner of Cook's membrane, plane strain, nu = 0.4999.
double cook_tip(bool b_bar, int n) {
  const auto m = support::cook_membrane(n);
  auto in = support::elastic(250.0, 0.4999);
  in.b_bar = b_bar;
  in.supports = {fixed_edge("wall", "left")};
  in.boundary_loads = {{"shear", "right", 0.0, {0.0, 6.25}, {}, ""}};
  const body::LinearBody b(body::make_shape(m), in);
  const auto s = support::solve_linear(b, in);
  return b.recover(s.q, s.factors)[support::node_at(m, {48, 60})].y();
}

// On Cook's membrane the plain quadrilateral must lock and B-bar must not.
TEST(elasticity, b_bar_does_not_lock) {
  const double reference = cook_tip(true, 48);
  EXPECT_LT(std::abs(cook_tip(true, 8) / reference - 1), 0.08) << cook_tip(true, 8) << " of " << reference;
  EXPECT_LT(cook_tip(false, 8) / reference, 0.6) << cook_tip(false, 8);
}

// A slender beam under an end load must bend as beam theory says, with reactions in balance.
TEST(elasticity, beam_bends_as_theory_says) {
  const double E = 1000.0, length = 20.0, height = 1.0, force = 1.0;
  const auto m = support::rectangle({.size = {length, height}, .nx = 160, .ny = 8});
  auto in = support::elastic(E, 0.0, Analysis::plane_stress);
  in.supports = {fixed_edge("wall", "left")};
  in.boundary_loads = {{"end", "right", 0.0, {0.0, force / height}, {}, ""}};
  const body::LinearBody b(body::make_shape(m), in);
  const auto s = support::solve_linear(b, in);
  const auto u = b.recover(s.q, s.factors);
  const double inertia = height * height * height / 12;
  const double bending = force * std::pow(length, 3) / (3 * E * inertia),
               shear = 1.2 * force * length / (E / 2 * height);
  EXPECT_NEAR(u[support::node_at(m, {length, 0.5})].y() / (bending + shear), 1.0, 0.01);
}

}  // namespace
