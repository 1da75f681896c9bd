#include <gtest/gtest.h>

#include <cmath>

#include "sim/measure/measure.hpp"
#include "sim/measure/nodal_depth.hpp"

using namespace reye;

namespace {

/// Nodes from -1 to 1 at distance h, shifted; pressure and shear as functions of x about `centre`.
template <class Pressure, class Shear>
sim::SurfaceRecord surface(double h, double shift, double centre, double friction, Pressure p, Shear q) {
  sim::SurfaceRecord s;
  for (int i = 0; i * h <= 2.0; ++i) {
    const double x = -1.0 + shift + i * h;
    s.node.push_back(i);
    s.arc_length_mm.push_back(x + 1.0);
    s.pressure_MPa.push_back(p(x - centre));
    s.shear_MPa.push_back(q(x - centre));
    const bool slips = std::abs(q(x - centre)) >= friction * p(x - centre) * (1.0 - 1e-12);
    s.status.push_back(p(x - centre) <= 0.0 ? 0 : slips ? 2 : 1);
  }
  return s;
}

double root(double x) { return x > 0.0 ? std::sqrt(x) : 0.0; }

double hertz(double x, double a) { return 300.0 * root(1.0 - x * x / (a * a)); }

/// Cattaneo-Mindlin: full slip traction less a smaller one of the same shape in the stick zone |x| < c.
double mindlin(double x, double mu, double a, double c) { return mu * (hertz(x, a) - c / a * hertz(x, c)); }

const auto no_shear = [](double) { return 0.0; };

}  // namespace

// The half width of an exact Hertz pressure must be exact wherever the nodes lie, however few they are.
TEST(Widths, ExactOnHertz) {
  for (const double a : {0.1, 0.37, 0.5})
    for (const double h : {0.01, 0.03, 0.045})
      for (int k = 0; k < 5; ++k) {
        const auto s = surface(
            h, 0.2 * k * h, 0.013, 0.0, [a](double x) { return hertz(x, a); }, no_shear);
        EXPECT_NEAR(sim::contact_half_width(s).value(), a, 1e-10 * a) << a << ' ' << h << ' ' << k;
      }
}

// The stick half width of an exact Cattaneo-Mindlin shear, of either sign, must be exact wherever the nodes lie.
TEST(Widths, ExactOnCattaneoMindlin) {
  const double a = 0.5, mu = 0.6;
  for (const double c : {0.15, 0.3, 0.45})
    for (int k = 0; k < 5; ++k)
      for (const double sign : {1.0, -1.0}) {
        const auto s = surface(
            0.025, 0.005 * k, 0.004, mu, [a](double x) { return hertz(x, a); },
            [&](double x) { return sign * mindlin(x, mu, a, c); });
        EXPECT_NEAR(sim::stick_half_width(s, mu).value(), c, 1e-9 * c) << c << ' ' << k;
        EXPECT_NEAR(sim::contact_half_width(s).value(), a, 1e-9 * a);
      }
}

// A contact of constant pressure must reach to its last loaded nodes, at most one element further.
TEST(Widths, FlatPressure) {
  const auto s = surface(
      0.1, 0.0, 0.0, 0.0, [](double x) { return std::abs(x) < 0.45 ? 10.0 : 0.0; }, no_shear);
  EXPECT_NEAR(sim::contact_half_width(s).value(), 0.4, 1e-12);
}

// Too few loaded or sticking nodes must give no width rather than a wrong one.
TEST(Widths, TooFewNodes) {
  const auto narrow = surface(
      0.1, 0.0, 0.0, 0.0, [](double x) { return hertz(x, 0.15); }, no_shear);
  EXPECT_FALSE(sim::contact_half_width(narrow));
  EXPECT_FALSE(sim::stick_half_width(sim::SurfaceRecord{}, 0.3));
  const auto sliding = surface(
      0.02, 0.0, 0.0, 0.3, [](double x) { return hertz(x, 0.5); }, [](double x) { return 0.3 * hertz(x, 0.5); });
  EXPECT_FALSE(sim::stick_half_width(sliding, 0.3));
}

// The scar must end where its depth falls below 0.5 % of the largest, between the nodes.
TEST(Widths, Scar) {
  sim::SurfaceRecord s;
  s.arc_length_mm = {0.0, 1.0, 2.0, 3.0, 4.0};
  s.wear_depth_mm = {0.0, 0.0, 1.0, 0.25, 0.0};
  EXPECT_NEAR(sim::scar_width(s), (3.0 + 0.245 / 0.25) - (2.0 - 0.995), 1e-14);
  s.wear_depth_mm = {1.0, 1.0, 1.0, 1.0, 1.0};
  EXPECT_EQ(sim::scar_width(s), 4.0);
  s.wear_depth_mm.assign(5, 0.0);
  EXPECT_EQ(sim::scar_width(s), 0.0);
  EXPECT_EQ(sim::scar_width({}), 0.0);
}

// On a ring widths and scar must be those of the contact, wherever the table begins.
TEST(Widths, RingCutAnywhere) {
  const int n = 200;
  const double h = 0.02, a = 0.41;
  for (const int seam : {0, 17, 100, 103, 199}) {
    sim::SurfaceRecord s;
    for (int k = 0; k <= n; ++k) {
      const int i = (seam + k) % n;
      const double x = (i - 100) * h, p = hertz(x, a);
      s.body.push_back(0);
      s.node.push_back(i);
      s.arc_length_mm.push_back(k * h);
      s.pressure_MPa.push_back(p);
      s.shear_MPa.push_back(mindlin(x, 0.3, a, 0.2));
      s.status.push_back(p <= 0.0 ? 0 : std::abs(x) < 0.2 ? 1 : 2);
      s.wear_depth_mm.push_back(std::max(0.0, 1.0 - x * x));
    }
    EXPECT_NEAR(sim::contact_half_width(s).value(), a, 1e-12) << seam;
    EXPECT_NEAR(sim::stick_half_width(s, 0.3).value(), 0.2, 1e-8) << seam;
    EXPECT_NEAR(sim::scar_width(s), 2.0 * (0.98 + h * (0.0396 - 0.005) / 0.0396), 1e-12) << seam;
    s.wear_depth_mm.assign(s.node.size(), 0.5);
    EXPECT_NEAR(sim::scar_width(s), n * h, 1e-12);
  }
}

// Depth must be removed volume over the full length of the node; the ledger must add what waits and what is gone.
TEST(Widths, DepthAndLedger) {
  mortar::Surface surface;
  surface.area = {0.5, 1.0, 0.25};
  EXPECT_EQ(sim::depths(surface, {1.0, 3.0, 1.0}), (std::vector{2.0, 3.0, 4.0}));
  contact::ContactState state;
  state.law_volume = 7.0;
  state.pending_secondary = {1.0, 2.0};
  state.strip_secondary = 4.0;
  state.pending_primary = {0.5};
  state.strip_primary = 0.25;
  const auto book = sim::ledger(state);
  EXPECT_EQ(book.asked, 7.0);
  EXPECT_EQ(book.removed_secondary, 7.0);
  EXPECT_EQ(book.removed_primary, 0.75);
}

// In the middle of a quadratic facet depth must be the value there, not the coefficient of the control point.
TEST(Widths, DepthInTheMiddleOfAFacet) {
  mortar::Surface surface;
  surface.area = {0.5, 0.5, 0.25};
  surface.facets = {{0, 1, 2}};
  EXPECT_EQ(sim::depths(surface, {1.0, 2.0, 1.0}), (std::vector{2.0, 4.0, 0.25 * (2.0 + 2.0 * 4.0 + 4.0)}));
}
