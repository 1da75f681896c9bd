#include <cmath>
#include <numbers>

#include "sim/problem/records.hpp"
#include "support/scene_words.hpp"
#include "wear_scene.hpp"

/// A thin body that bends and slides round a curve.
namespace reye::verification {

namespace {

// A belt pulled over a drum must end with the tensions of Euler and Eytelwein, its friction at the drum and its tension
// in its middle, and its ledger must hold; an increment of it must take few iterations of Newton.
TEST(Belt, SlidesRoundADrum) {
  constexpr double slack = 5.0, friction = 0.2, drum = 50.0, thickness = 2.0;
  const auto belt = played(scene_text("capstan", {}));
  ASSERT_EQ(belt.summary.status, sim::RunStatus::done) << belt.summary.reason;
  const double tight = -belt.records.back().support_forces.at(1).y();
  EXPECT_NEAR(tight / slack / std::exp(friction * std::numbers::pi * drum / (drum + 0.5 * thickness)), 1.0, 1e-3);
  EXPECT_LT(belt.contact().ledger_relative_error.value(), 1e-9);
  const auto& counts = belt.summary.counts;
  EXPECT_EQ(counts.cutbacks, 0);
  EXPECT_LE(static_cast<double>(counts.newton_iterations), 6.0 * static_cast<double>(counts.increments));
}

}  // namespace

}  // namespace reye::verification
