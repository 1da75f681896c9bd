#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "body/operator.hpp"
#include "fem/finite.hpp"
#include "membrane.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Kinematics;
using base::Vec2;
using base::Vector;
using body::Drive;
using support::fixed_edge;
using support::made_of;
using support::moved;

body::Support held(const std::string& edge, char axis) {
  body::Support s;
  s.name = s.edge = edge;
  (axis == 'x' ? s.x : s.y).drive = Drive::fixed;
  return s;
}

Vector nodal(const body::NonlinearBody& b, const support::NonlinearSolution& s) {
  const auto points = b.recover(s.q, s.state.y);
  Vector u(2 * points.size());
  for (size_t k = 0; k < points.size(); ++k) u.segment<2>(2 * k) = points[k];
  return u;
}

/// Rise of the tip of Cook's membrane of a nearly incompressible neo-Hookean solid, kappa = 5000 mu.
double rubber_tip(bool cure, int n) {
  const auto m = support::cook_membrane(n);
  const double mu = 80.1938, lambda = 400889.8;
  const double E = mu * (3 * lambda + 2 * mu) / (lambda + mu), nu = lambda / (2 * (lambda + mu));
  auto in = made_of(material::NeoHookean{E, nu, material::Volumetric::log_squared}, Kinematics::finite);
  in.b_bar = cure;
  in.supports = {fixed_edge("wall", "left")};
  in.boundary_loads = {{"shear", "right", 0.0, {0.0, 100.0 / 16.0}, {}, ""}};
  const body::NonlinearBody b(body::make_shape(m), in);
  const auto s = support::solve_nonlinear(b, in, 30, 1e-9);
  EXPECT_LT(s.table.back(), 1e-9);
  return b.recover(s.q, s.state.y)[support::node_at(m, {48, 60})].y();
}

// On Cook's membrane at finite strain the plain quadrilateral must lock, and F-bar must converge without.
TEST(nonlinear_physics, f_bar_does_not_lock) {
  const double coarse = rubber_tip(true, 4), medium = rubber_tip(true, 8), fine = rubber_tip(true, 16),
               finest = rubber_tip(true, 32);
  EXPECT_LT(std::abs(medium / finest - 1), 0.08) << medium << " of " << finest;
  EXPECT_LT(std::abs(finest - fine), 0.6 * std::abs(fine - medium))
      << coarse << " " << medium << " " << fine << " " << finest;
  EXPECT_LT(rubber_tip(false, 8) / finest, 0.6);
}

// A nearly incompressible block pressed between smooth walls must need no more force on a distorted mesh than the
// uniform state says.
TEST(nonlinear_physics, confined_compression_does_not_lock) {
  const auto m = support::rectangle({.size = {2, 1}, .nx = 6, .ny = 4, .distortion = 0.7});
  const material::Material stiff = material::NeoHookean{100.0, 0.4999, material::Volumetric::log_squared};
  auto in = made_of(stiff, Kinematics::finite);
  in.supports = {held("left", 'x'), held("right", 'x'), held("bottom", 'y'), held("top", 'y')};
  in.supports[3].y = moved(-0.001);
  const body::NonlinearBody b(body::make_shape(m), in);
  const auto s = support::solve_nonlinear(b, in);
  const double mu = 100.0 / (2 * 1.4999), lambda = 100.0 * 0.4999 / (1.4999 * (1 - 2 * 0.4999)), F = 0.999;
  const double P = (mu * (F * F - 1) + lambda * std::log(F)) / F;
  const Vector r = b.retained_residual(s.state, s.state.y, s.q, s.factors);
  for (const auto& c : b.support_columns())
    if (c.support == 3) {
      EXPECT_NEAR(r[c.column], 2.0 * P, 1e-9 * std::abs(P));
    }
}

// A thick pipe of nearly incompressible rubber under a pressure that follows its wall must open as the closed solution
// says: from 1 to 1.5 at the inside, p = mu (ln(a/b) + 1/(2 b^2) - 1/(2 a^2)) with the hoop stretches a, b of its
// walls.
TEST(nonlinear_physics, rubber_pipe) {
  const double mu = 1.0, nu = 0.49999, a = 1.5, b = std::sqrt(4.0 + 1.25) / 2.0;
  const double pressure = mu * (std::log(a / b) + 0.5 / (b * b) - 0.5 / (a * a));
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric}) {
    const bool ring = analysis == Analysis::axisymmetric;
    auto in = made_of(material::NeoHookean{2 * mu * (1 + nu), nu, material::Volumetric::log_squared},
                      Kinematics::finite, analysis);
    in.supports = {held("bottom", 'y'), held("top", ring ? 'y' : 'x')};
    in.boundary_loads = {{"inside", "left", pressure, {0.0, 0.0}, {}, ""}};
    const auto error = [&](int n) {
      const auto mesh = ring ? support::rectangle({.corner = {1, 0}, .size = {1, 0.2}, .nx = n, .ny = 2})
                             : support::ring({.across = n, .around = 2 * n});
      const body::NonlinearBody pipe(body::make_shape(mesh), in);
      const auto s = support::solve_nonlinear(pipe, in, 10, 1e-9);
      EXPECT_LT(s.table.back(), 1e-9);
      return std::abs(pipe.recover(s.q, s.state.y)[support::node_at(mesh, {1.0, 0.0})].x() - (a - 1.0));
    };
    const double coarse = error(8), fine = error(16);
    EXPECT_LT(fine, 5e-3);
    EXPECT_GT(std::log2(coarse / fine), 1.8) << coarse << " " << fine;
  }
}

/// Displacement of the outer and stress at the inner radius of a thick cylinder, 1 < r < 2, under the inner pressure
/// that makes it plastic up to r = 1.5: elastic, perfectly plastic, Mises, incompressible, length held.
struct Cylinder {
  double yield = 10.0, E = 3000.0, nu = 0.4999;
  double k() const { return yield / std::sqrt(3.0); }
  double pressure() const { return k() * (2 * std::log(1.5) + 1 - 1.5 * 1.5 / 4); }
  double outer_displacement() const { return k() * 1.5 * 1.5 / (2 * 2.0 * E / (2 * (1 + nu))); }
  material::Material material() const { return material::HenckyJ2{E, nu, material::LinearHardening{yield, 0.0}}; }

  /// Relative errors: outer displacement; radial stress over 1 < r < 2, root mean square over the nodes.
  std::pair<double, double> errors(const mesh::Mesh& mesh, body::BodyInput in) const {
    in.boundary_loads = {{"inside", "left", pressure(), {0.0, 0.0}, {}, ""}};
    const body::NonlinearBody b(body::make_shape(mesh), in);
    const auto s = support::solve_nonlinear(b, in, 8, 1e-9);
    EXPECT_LT(s.table.back(), 1e-9);
    const Vector u = nodal(b, s);
    const int end = support::node_at(mesh, {2.0, 0.0});
    const auto state = fem::nodal_state(mesh, {in.material, in.analysis, in.kinematics, in.b_bar}, u, s.state.history);
    double sum = 0.0;
    int count = 0;
    for (int node = 0; node < mesh.node_count(); ++node) {
      const double r = in.analysis == Analysis::axisymmetric ? mesh.X[node].x() : mesh.X[node].norm();
      if (std::abs(mesh.X[node].y()) > 1e-9) continue;  // along the x axis: 11 is the radial direction
      const double exact =
          r < 1.5 ? k() * (2 * std::log(r / 1.5) - 1 + 1.5 * 1.5 / 4) : k() * 1.5 * 1.5 * (0.25 - 1 / (r * r));
      sum += std::pow((state.stress[node][0] - exact) / pressure(), 2);
      ++count;
    }
    return {std::abs(u[2 * end] / outer_displacement() - 1), std::sqrt(sum / count)};
  }
};

// A thick cylinder, plastic over half its wall, must meet the closed solution, in the plane and as a ring.
TEST(nonlinear_physics, plastic_cylinder) {
  const Cylinder c;
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric}) {
    const bool ring = analysis == Analysis::axisymmetric;
    auto in = made_of(c.material(), Kinematics::small, analysis);
    in.supports = {held("bottom", 'y'), held("top", ring ? 'y' : 'x')};
    const auto mesh = [&](int n) {
      return ring ? support::rectangle({.corner = {1, 0}, .size = {1, 0.2}, .nx = n, .ny = 2})
                  : support::ring({.across = n, .around = 2 * n});
    };
    const auto coarse = c.errors(mesh(10), in), fine = c.errors(mesh(20), in);
    EXPECT_LT(fine.first, 2e-3);
    EXPECT_LT(fine.second, 1.5e-2);
    EXPECT_GT(coarse.second / fine.second, 2.0) << coarse.second << " " << fine.second;
  }
}

}  // namespace
