#include "support/half_plane.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "verification/contact_scene.hpp"

/// The half-plane reference against closed forms, with its rates; Reye against it.
namespace reye::verification {

namespace {

using half_plane::Grid;
using half_plane::Vector;

/// Steel cylinder, radius 6 mm, on steel: geo/partial_slip_life. Lengths in mm, forces in N per mm.
struct Cylinder {
  static constexpr double E = 200e3, nu = 0.3, radius = 6.0, P = 120.0, mu = 0.6, E_star = E / (2.0 * (1.0 - nu * nu));
  static inline const double a = std::sqrt(4.0 * P * radius / (M_PI * E_star)), p0 = 2.0 * P / (M_PI * a);
};

double stick(double share) { return Cylinder::a * std::sqrt(1.0 - share); }  ///< Q = share mu P

Vector round(const Grid& grid) { return grid.x.array().square() / (2.0 * Cylinder::radius); }

Vector values(const Grid& grid, const std::function<double(double)>& f) {
  return grid.x.unaryExpr([&](double x) { return f(x); });
}

double rms(const Grid& grid, const Vector& error) {
  return std::sqrt(grid.width.dot(error.cwiseAbs2()) / grid.width.sum());
}

/// The error on so many cells: root of the mean square over eight positions of the contact's edge between the points.
double error_on(int cells, const std::function<double(const Grid&)>& error) {
  double sum = 0.0;
  for (int k = 0; k < 8; ++k)
    sum += std::pow(error(half_plane::make_grid(0.12 * (1.0 + k / (8.0 * cells)), cells, Cylinder::E_star)), 2);
  return std::sqrt(sum / 8.0);
}

double rate(int cells, const std::function<double(const Grid&)>& error) {
  return std::log2(error_on(cells, error) / error_on(2 * cells, error));
}

/// Slip at Q of a first loading (references B3), mu / 2R [x sqrt(x^2 - c^2) - c^2 arccosh(x / c)].
double first_slip(double x, double c) {
  return x <= c ? 0.0
                : Cylinder::mu / (2.0 * Cylinder::radius) * (x * std::sqrt(x * x - c * c) - c * c * std::acosh(x / c));
}

/// Ciavarella and Hills' depth without further wear, of both bodies together.
double depth_limit(double x, double c) {
  if (x <= c) return 0.0;
  return std::max(
      0.0, (Cylinder::a * Cylinder::a * std::acosh(x / c) - x * std::sqrt(x * x - c * c)) / (2.0 * Cylinder::radius));
}

/// `alpha_N`: of 1 mm^3/J, 1e-3 mm^2/N.
half_plane::Worn worn(const Grid& grid, double share, double alpha_N, int steps) {
  return half_plane::wear(grid, round(grid), {Cylinder::P, share * Cylinder::mu * Cylinder::P, Cylinder::mu},
                          1e-3 * alpha_N, steps);
}

const Grid& fine_grid() {
  static const Grid grid = half_plane::make_grid(0.115, 120, Cylinder::E_star);
  return grid;
}

}  // namespace

// The reference's pressure must converge to Hertz's with h, and its approach to Hertz's parabola in the contact.
TEST(HalfPlane, Hertz) {
  const auto error = [](const Grid& grid) {
    return rms(grid, half_plane::press(grid, round(grid), Cylinder::P).p -
                         values(grid, [](double x) { return hertz(x, Cylinder::a, Cylinder::p0); })) /
           Cylinder::p0;
  };
  EXPECT_GT(rate(40, error), 0.9);
  EXPECT_LT(error(fine_grid()), 3e-3);
  EXPECT_NEAR(half_plane::press(fine_grid(), round(fine_grid()), Cylinder::P).p[0], Cylinder::p0, 1e-4 * Cylinder::p0);
}

// Shear and slip of a first loading must converge to Cattaneo and Mindlin's, the energy of a cycle to its closed form.
TEST(HalfPlane, CattaneoMindlin) {
  const auto sheared = [](const Grid& grid, double share) {
    return half_plane::shear(grid, Cylinder::mu * half_plane::press(grid, round(grid), Cylinder::P).p,
                             share * Cylinder::mu * Cylinder::P);
  };
  for (const double share : {0.25, 0.5, 0.75}) {
    const double c = stick(share);
    const auto q = [&](double x) {
      return Cylinder::mu * (hertz(x, Cylinder::a, Cylinder::p0) - hertz(x, c, Cylinder::p0 * c / Cylinder::a));
    };
    EXPECT_GT(rate(40, [&](const Grid& g) { return rms(g, sheared(g, share).q - values(g, q)); }), 0.9) << share;
    const auto slip = [&](const Grid& g) {
      const auto s = sheared(g, share).slip;
      const Vector inside = values(g, [](double x) { return x < Cylinder::a ? 1.0 : 0.0; });
      const Vector exact = values(g, [&](double x) { return first_slip(x, c); });
      return rms(g, inside.cwiseProduct(s - exact)) / first_slip(Cylinder::a, c);
    };
    EXPECT_GT(rate(40, slip), 1.0) << share;
    EXPECT_LT(slip(fine_grid()), 1e-3) << share;
  }
  const std::pair<double, double> energies[] = {
      {0.25, 1.79499e-4}, {0.5, 1.70741e-3}, {0.75, 7.33844e-3}};  // references B3
  for (const auto& [share, E_c] : energies) {
    const auto p = half_plane::press(fine_grid(), round(fine_grid()), Cylinder::P).p;
    const auto s = half_plane::shear(fine_grid(), Cylinder::mu * p, share * Cylinder::mu * Cylinder::P).slip;
    EXPECT_NEAR(fine_grid().width.dot(Vector(4.0 * Cylinder::mu * p.cwiseProduct(s))), E_c, 0.01 * E_c) << share;
  }
}

// There and back between -Q and Q a point must slip by twice the slip of a first loading, and that slip must be mu
// times the gap of the same shape pressed by P - Q / mu, worn or not: dw/dN = 4 alpha mu^2 p G. The gap must grow as
// the depth.
TEST(HalfPlane, SlipIsTheGapOfLessLoad) {
  const auto& grid = fine_grid();
  const double Q = 0.6 * Cylinder::mu * Cylinder::P;
  const auto gap = [&](const Vector& shape) {
    return half_plane::press(grid, shape, Cylinder::P - Q / Cylinder::mu).gap;
  };
  const Vector depth = worn(grid, 0.6, 2.5, 20).depth, unworn = gap(round(grid));
  for (const Vector& shape : {round(grid), Vector(round(grid) + depth)}) {
    const Vector p = half_plane::press(grid, shape, Cylinder::P).p, G = gap(shape);
    const auto first = half_plane::shear(grid, Cylinder::mu * p, Q),
               range = half_plane::shear(grid, 2.0 * Cylinder::mu * p, 2.0 * Q);
    for (int i = 0; i < p.size(); ++i) {
      if (p[i] <= 0.0) continue;
      EXPECT_NEAR(first.slip[i], Cylinder::mu * G[i], 1e-12 * Cylinder::radius);
      EXPECT_NEAR(range.slip[i], 2.0 * first.slip[i], 1e-12 * Cylinder::radius);
    }
  }
  EXPECT_LT((gap(round(grid) + depth) - unworn - depth).cwiseAbs().maxCoeff(), 1e-9 * depth.maxCoeff());
}

// The stick zone must stay, and wear end at Ciavarella and Hills' profile, nearer with h; on the way it must pass the
// shares 0.600, 0.977 and 0.999 of that depth (references B4), of second order in the steps.
TEST(HalfPlane, WearsToTheLimitProfile) {
  const double c = stick(0.5), x = std::sqrt(0.5 * (Cylinder::a * Cylinder::a + c * c)), deepest = depth_limit(x, c);
  const auto error = [&](const Grid& g) {
    return rms(g, worn(g, 0.5, 100.0, 16).depth - values(g, [&](double at) { return depth_limit(at, c); })) / deepest;
  };
  EXPECT_GT(rate(20, error), 0.8);
  const std::pair<double, double> shares[] = {{2.5, 0.600}, {7.5, 0.977}, {25.0, 0.999}};
  for (const auto& [alpha_N, share] : shares)
    EXPECT_NEAR(worn(fine_grid(), 0.5, alpha_N, 20).depth.maxCoeff(), share * deepest, 0.015 * deepest) << alpha_N;
  const auto in_steps = [&](int steps) {
    return half_plane::area(fine_grid(), worn(fine_grid(), 0.5, 2.5, steps).depth);
  };
  EXPECT_GT(std::log2((in_steps(4) - in_steps(8)) / (in_steps(8) - in_steps(16))), 1.6);
}

}  // namespace reye::verification
