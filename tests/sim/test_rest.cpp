#include <gtest/gtest.h>

#include "problem_of.hpp"
#include "sim/study/run.hpp"

using namespace reye;

namespace {

/// The two blocks, pressed by this motion or force.
sim::Summary blocks_under(const std::string& stroke_mm, const std::string& press) {
  const auto problem = test::problem_of(test::with(
      test::block_scene, {{"motion_mm = 0.01", "motion_mm = " + stroke_mm}, {"force_N_per_mm = -20.0", press}}));
  auto state = sim::initial_state(problem);
  return sim::run(problem, state, {});
}

void expect_at_rest(const sim::Summary& summary) {
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_EQ(summary.cycles, 40.0);
  const auto& pad = summary.contacts[0];
  EXPECT_EQ(pad.normal_force, 0.0);
  EXPECT_EQ(pad.dissipated_energy, 0.0);
  EXPECT_EQ(pad.secondary.worn_area + pad.primary.worn_area, 0.0);
  EXPECT_EQ(pad.ledger_relative_error.value_or(1.0), 0.0);
}

}  // namespace

// Bodies that touch and are neither moved nor loaded must stay at rest, and nothing must wear.
TEST(Rest, WithoutMotion) { expect_at_rest(blocks_under("0.0", "motion_mm = 0.0")); }

// Bodies must stay at rest where one is held by nothing but the contact that no force closes, and where it slides so.
TEST(Rest, WithoutForce) {
  expect_at_rest(blocks_under("0.0", "force_N_per_mm = 0.0"));
  expect_at_rest(blocks_under("0.01", "force_N_per_mm = 0.0"));
}

// Loads and strokes that are denormal numbers must count as none: no failure, and a ledger that closes.
TEST(Rest, BelowWhatNumbersTell) {
  expect_at_rest(blocks_under("0.01", "motion_mm = -1e-310"));
  expect_at_rest(blocks_under("1e-310", "force_N_per_mm = -1e-310"));
}
