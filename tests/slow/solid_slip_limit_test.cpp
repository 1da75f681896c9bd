#include <gtest/gtest.h>

#include "support/solid_slip_limit.hpp"

using namespace reye;

TEST(SolidSlipLimit, FormIsThatOfItsReference) {
  // At q = 0.5 c / a = 0.793701, w R / a^2 = 0.094485 and V R / a^4 = 0.132158; at q = 0.1 0.965489, 0.005579,
  // 0.001261.
  const auto at = [](double q) {
    support::SlipLimitCase c;
    c.q = q;
    const double a = c.hertz().a_mm, R = c.hertz().R_mm, stick = c.mindlin().stick_radius();
    const auto [depth, volume] = c.limit(stick).depth_and_volume();
    return std::array{stick / a, depth * R / (a * a), volume * R / std::pow(a, 4)};
  };
  const auto half = at(0.5), tenth = at(0.1);
  EXPECT_NEAR(half[0], 0.793701, 1e-6);
  EXPECT_NEAR(half[1], 0.094485, 1e-6);
  EXPECT_NEAR(half[2], 0.132158, 1e-6);
  EXPECT_NEAR(tenth[0], 0.965489, 1e-6);
  EXPECT_NEAR(tenth[1], 0.005579, 1e-6);
  EXPECT_NEAR(tenth[2], 0.001261, 1e-6);
}

TEST(SolidSlipLimit, PressureOfTheLimitCarriesTheForce) {
  // Its integral over the stick disc, r = c sin t, is the force at any stick radius.
  support::SlipLimitCase c;
  for (const double q : {0.1, 0.5, 0.75}) {
    c.q = q;
    const auto limit = c.limit(c.mindlin().stick_radius());
    constexpr int intervals = 2000;
    const double step = 0.5 * std::numbers::pi / intervals;
    double force = 0.0;
    for (int k = 0; k < intervals; ++k) {
      const double t = (k + 0.5) * step, r = limit.c * std::sin(t);
      force += 2.0 * std::numbers::pi * r * limit.pressure(r) * limit.c * std::cos(t) * step;
    }
    EXPECT_NEAR(force, limit.force, 1e-6 * limit.force) << q;
  }
}

TEST(SolidSlipLimit, PartialSlipWearsUntilNothingSlips) {
  // At half of the force that slips, ten times as long as its first wear would need for the limit and on eight elements
  // per radius, the edge of stick is within half an element of Cattaneo's, the worn volume within 5 % of the limit's,
  // and nothing inside the edge has worn.
  const support::SlipLimitCase c;
  const auto run = support::play_slip_limit(c);
  ASSERT_EQ(run.played.summary.status, sim::RunStatus::done) << run.played.summary.reason;
  const double h = c.hertz().a_mm / c.elements, exact = c.mindlin().stick_radius();
  const auto [depth, volume] = c.limit(exact).depth_and_volume();
  EXPECT_NEAR(run.stick_radius, exact, 0.5 * h);
  EXPECT_NEAR(run.volume, volume, 0.05 * volume);
  EXPECT_NEAR(run.depth, depth, 0.25 * depth);
  const auto& worn = run.played.frames.back().surfaces[0];
  for (std::size_t j = 0; j < worn.x_mm.size(); ++j)
    if (worn.x_mm[j].norm() < exact - h) {
      EXPECT_LE(worn.wear_depth_mm[j], 1e-3 * depth) << worn.x_mm[j].transpose();
    }
}

TEST(SolidSlipLimit, ARecedingEdgeIsReported) {
  // Near full slip cubes, stiff in shear, lose the edge of stick: a run must say so, and by how much the depth is too
  // large in the end. At q = 0.85 a stick radius of 0.53 a ends at 0.85 of it.
  support::SlipLimitCase c{
      .q = 0.85, .elements = 8.0, .fine = 1.4, .way = 3.0, .jump = 1.0, .increments = 2, .implicit_wear = false};
  const auto run = support::play_slip_limit(c);
  ASSERT_EQ(run.played.summary.status, sim::RunStatus::done) << run.played.summary.reason;
  const auto& warnings = run.played.summary.warnings;
  EXPECT_LT(run.stick_radius, 0.9 * c.mindlin().stick_radius());
  const auto found =
      std::find_if(warnings.begin(), warnings.end(), [](const auto& w) { return w.kind == "stick_zone"; });
  ASSERT_NE(found, warnings.end());
  EXPECT_NE(found->text.find("too large in the end"), std::string::npos) << found->text;
}
