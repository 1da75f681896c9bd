#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

#include "sim/march/levelling.hpp"

using namespace reye;

namespace {

/// A run whose pressures change by so much from play to play. What is restored has been played all the same.
struct Scripted {
  std::vector<double> changes;  ///< by each play; infinite: nothing is carried
  int fails_at = 0;             ///< number of the play that does not come to its end; 0: none
  bool may_return = true;
  std::vector<double> played{};  ///< cycles of all plays
  std::vector<double> whole{};   ///< of those that were not undone
  std::vector<bool> ends{};      ///< of those

  bool play(double cycles, bool end) {
    played.push_back(cycles);
    whole.push_back(cycles);
    ends.push_back(end);
    return static_cast<int>(played.size()) != fails_at;
  }
  double change() const { return changes.at(played.size() - 1); }
  std::size_t kept() const { return whole.size(); }
  bool restore(std::size_t kept) {
    whole.resize(kept);
    ends.resize(kept);
    return may_return;
  }
};

constexpr double unknown = std::numeric_limits<double>::infinity();
using Cycles = std::vector<double>;
using enum sim::PlayedBefore;

/// Whether what is left of the plays is all cycles, with one end.
void expect_whole(const Scripted& run) {
  for (std::size_t k = 0; k < run.ends.size(); ++k) EXPECT_EQ(run.ends[k], k + 1 == run.ends.size());
  EXPECT_EQ(std::accumulate(run.whole.begin(), run.whole.end(), 0.0), 64.0);
}

Cycles by_halves(bool last, const std::vector<double>& changes, double& left) {
  Scripted run{changes};
  double first = -1.0;
  left = sim::level_by_halves(64.0, last, run, first);
  EXPECT_EQ(first, changes.front());
  expect_whole(run);
  return run.whole;
}

/// All plays on the way, those that are undone, too.
Cycles on_the_way(sim::PlayedBefore before, const std::vector<double>& changes) {
  Scripted run{changes};
  bool at_once = true;
  sim::level(64.0, false, before, run, at_once);
  expect_whole(run);
  EXPECT_EQ(at_once, run.played.size() == 1);
  return run.played;
}

}  // namespace

// Levelling cycles must halve until pressures repeat, more closely at the end of a step, and be all cycles together.
TEST(Levelling, HalvesUntilPressuresRepeat) {
  double left = 0.0;
  EXPECT_EQ(by_halves(false, {0.0, 0.02}, left), (Cycles{32.0, 16.0, 16.0}));
  EXPECT_EQ(left, 0.02);
  EXPECT_EQ(by_halves(true, {0.0, 0.02, 0.005}, left), (Cycles{32.0, 16.0, 8.0, 8.0}));
  EXPECT_EQ(left, 0.005);
  EXPECT_EQ(by_halves(false, Cycles(8, 0.1), left).size(), 8u);
  EXPECT_EQ(left, 0.1);
}

// Cycles that end unloaded show no pressures: by halves two must do on the way, at the end of a step all are played.
TEST(Levelling, UnloadedEnds) {
  double left = 0.0;
  EXPECT_EQ(by_halves(false, Cycles(8, unknown), left).size(), 2u);
  EXPECT_EQ(left, unknown);  // of which no warning is given
  EXPECT_EQ(by_halves(true, Cycles(8, unknown), left).size(), 8u);
}

// A play that does not come to its end must be the last one, and nothing may be said of its pressures.
TEST(Levelling, EndsWithAFailedPlay) {
  Scripted run{Cycles(8, 0.1), 2};
  double first = 0.0;
  EXPECT_EQ(sim::level_by_halves(64.0, true, run, first), 0.0);
  EXPECT_EQ(run.played.size(), 2u);
}

// On the way one play must do where it changes pressures by little, less after plays of half of a block; where it
// changes them by more its start must be returned to and all cycles be played by halves.
TEST(Levelling, AtOnceWherePressuresFit) {
  const Cycles at_once{64.0}, in_vain{64.0, 32.0, 16.0, 16.0};
  EXPECT_EQ(on_the_way(continued, {0.099}), at_once);
  EXPECT_EQ(on_the_way(continued, {0.101, 0.0, 0.0}), in_vain);
  EXPECT_EQ(on_the_way(in_halves, {0.074}), at_once);
  EXPECT_EQ(on_the_way(in_halves, {0.076, 0.0, 0.0}), in_vain);
  EXPECT_EQ(on_the_way(continued, {unknown}), at_once);
}

// A failed play must leave nothing on the way, and at the end of a step no play is tried at once.
TEST(Levelling, HalvesWhereOnePlayFails) {
  Scripted run{Cycles(8, 0.0), 1};
  bool at_once = true;
  sim::level(64.0, false, continued, run, at_once);
  expect_whole(run);
  EXPECT_EQ(run.whole, (Cycles{32.0, 16.0, 16.0}));
  Scripted end{Cycles(8, 0.0)};
  sim::level(64.0, true, continued, end, at_once);
  EXPECT_EQ(end.played, (Cycles{32.0, 16.0, 16.0}));
}

// Where one play has not served it must not be tried, until half of the cycles change pressures by half as much.
TEST(Levelling, TriesOnePlayAgainWhereItWouldServe) {
  bool at_once = false;
  Scripted still{{0.051, 0.0}}, again{{0.049, 0.0}};
  sim::level(64.0, false, continued, still, at_once);
  EXPECT_EQ(still.played, (Cycles{32.0, 16.0, 16.0}));
  EXPECT_FALSE(at_once);
  sim::level(64.0, false, continued, again, at_once);
  EXPECT_EQ(again.played, (Cycles{32.0, 16.0, 16.0}));
  EXPECT_TRUE(at_once);
}

// A run that is to end in a play must not be levelled further.
TEST(Levelling, EndsWithAnInterruptedPlay) {
  Scripted run{{}, 1, false};
  bool at_once = true;
  EXPECT_EQ(sim::level(64.0, false, continued, run, at_once), 0.0);
  EXPECT_EQ(run.played.size(), 1u);
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
