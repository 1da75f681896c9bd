#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

#include "sim/march/levelling.hpp"

using namespace reye;

namespace {

/// Cycles of each play where pressures change by so much from each to the next; `left`: the change that is returned.
std::vector<double> plays_of(bool last, const std::vector<double>& changes, double& left) {
  std::vector<double> cycles;
  std::vector<bool> ends;
  const auto play = [&](double jump, bool end) {
    cycles.push_back(jump);
    ends.push_back(end);
    return true;
  };
  left = sim::level_by_halves(64.0, last, play, [&] { return changes.at(cycles.size() - 1); });
  for (std::size_t k = 0; k < ends.size(); ++k) EXPECT_EQ(ends[k], k + 1 == ends.size());
  EXPECT_EQ(std::accumulate(cycles.begin(), cycles.end(), 0.0), 64.0);
  return cycles;
}

}  // namespace

// Levelling cycles must halve until pressures repeat, more closely at the end of a step, and be all cycles together.
TEST(Levelling, HalvesUntilPressuresRepeat) {
  double left = 0.0;
  EXPECT_EQ(plays_of(false, {0.0, 0.02}, left), (std::vector<double>{32.0, 16.0, 16.0}));
  EXPECT_EQ(left, 0.02);
  EXPECT_EQ(plays_of(true, {0.0, 0.02, 0.005}, left), (std::vector<double>{32.0, 16.0, 8.0, 8.0}));
  EXPECT_EQ(left, 0.005);
  EXPECT_EQ(plays_of(false, std::vector<double>(8, 0.1), left).size(), 8u);
  EXPECT_EQ(left, 0.1);
}

// Cycles that end unloaded show no pressures: on the way two must do, at the end of a step all are played.
TEST(Levelling, UnloadedEnds) {
  const std::vector<double> unknown(8, std::numeric_limits<double>::infinity());
  double left = 0.0;
  EXPECT_EQ(plays_of(false, unknown, left).size(), 2u);
  EXPECT_EQ(plays_of(true, unknown, left).size(), 8u);
}

// A play that does not come to its end must be the last one, and nothing may be said of its pressures.
TEST(Levelling, EndsWithAFailedPlay) {
  int plays = 0;
  EXPECT_EQ(sim::level_by_halves(
                64.0, true, [&](double, bool) { return ++plays < 2; }, [] { return 0.1; }),
            0.0);
  EXPECT_EQ(plays, 2);
}

// Pressures that still change where they are shown must be reported, and only those.
TEST(Levelling, WhatIsReported) {
  scene::Step step;
  step.name = "wear";
  EXPECT_FALSE(sim::uneven(step, 10.0, 0.02));
  EXPECT_FALSE(sim::uneven(step, 10.0, std::numeric_limits<double>::infinity()));
  const auto warning = sim::uneven(step, 10.0, 0.08);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, "pressures");
  EXPECT_NE(warning->text.find("cycle 10 are uncertain by 8 %"), std::string::npos) << warning->text;
}
