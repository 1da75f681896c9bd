#include <gtest/gtest.h>

#include <algorithm>

#include "played.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/problem/block_wear.hpp"
#include "sim/problem/rules.hpp"
#include "solid_runs.hpp"
#include "support/solid_worn.hpp"

using namespace reye;

namespace {

bool warns(const std::vector<sim::Warning>& warnings) {
  const auto kinds = test::kinds_of(warnings);
  return std::find(kinds.begin(), kinds.end(), "pressures, step wear") != kinds.end();
}

/// A ball rubbed to and fro that wears.
sim::SolidProblem worn_ball(double jump) {
  auto problem = test::rubbed_ball();
  problem.contacts[0].options.wear = support::archard(4e-5);
  auto& step = problem.scene.steps.back();
  step.name = "wear";
  step.wear = true;
  step.increments = 8;
  step.cycles = 40.0;
  step.jump = jump;
  problem.scene.steps.front().name = "press";
  return problem;
}

}  // namespace

// The shares of all wear of a block and of a cycle must be compared place by place, on the side where they differ most.
TEST(WatchJump, WornElsewhere) {
  const sim::Volumes block{{{{1.0, 2.0}, {1.0}}}}, cycle{{{{0.25, 0.25}, {0.1}}}};
  // Secondary: a third and two thirds for a half each; primary: all in one place.
  EXPECT_NEAR(sim::worn_elsewhere(block, cycle), 2.0 / 6.0, 1e-14);
  EXPECT_NEAR(sim::worn_elsewhere(block, {{{{0.1, 0.2}, {0.5}}}}), 0.0, 1e-14);
  EXPECT_EQ(sim::worn_elsewhere(block, {{{{0.0, 0.0}, {0.0}}}}), 0.0);  // a cycle that wears nothing says nothing
}

// Only the last step that wears is asked, and only where it jumps by blocks of one size.
TEST(WatchJump, LastToJump) {
  scene::Step press, worn, jumped;
  for (auto* step : {&worn, &jumped}) step->wear = true, step->cycles = 100.0;
  press.wear = false;
  jumped.jump = 10.0;
  const std::vector<scene::Step> steps{press, jumped, jumped, press};
  EXPECT_FALSE(sim::last_to_jump(steps, steps[0]));
  EXPECT_FALSE(sim::last_to_jump(steps, steps[1]));
  EXPECT_TRUE(sim::last_to_jump(steps, steps[2]));
  const std::vector<scene::Step> by_cycles{jumped, worn};
  EXPECT_FALSE(sim::last_to_jump(by_cycles, by_cycles[0]));
  EXPECT_FALSE(sim::last_to_jump(by_cycles, by_cycles[1]));
  jumped.jump_tolerance = 0.01;
  const std::vector<scene::Step> controlled{jumped};
  EXPECT_FALSE(sim::last_to_jump(controlled, controlled[0]));
}

// A warning must give the share that was found, and none where blocks wear as a cycle does.
TEST(WatchJump, Words) {
  scene::Step step;
  step.name = "wear";
  EXPECT_FALSE(sim::uneven_jump(step, 100.0, 10.0, 0.02));
  const auto warning = sim::uneven_jump(step, 100.0, 10.0, 0.17);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->severity, 0.17);
  EXPECT_NE(warning->text.find("17 %"), std::string::npos) << warning->text;
}

// Long blocks of solids must be named, shorter ones not, and the cycle that is played to find out leaves nothing.
TEST(WatchJump, Solids) {
  const auto coarse = test::play_and_keep(worn_ball(20.0)).played, fine = test::play_and_keep(worn_ball(1.25)).played;
  for (const auto* played : {&coarse, &fine}) {
    ASSERT_EQ(played->summary.status, sim::RunStatus::done) << played->summary.reason;
    EXPECT_DOUBLE_EQ(played->summary.cycles, 40.0);
    EXPECT_LT(played->summary.contacts[0].ledger_relative_error.value(), 1e-12);
  }
  EXPECT_EQ(coarse.summary.counts.cycles_solved, 2);
  EXPECT_TRUE(warns(coarse.summary.warnings));
  EXPECT_FALSE(warns(fine.summary.warnings));
}
