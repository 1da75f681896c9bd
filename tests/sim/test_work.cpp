#include "sim/march/work.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/study/forecast.hpp"

using namespace reye;

namespace {

/// Increments solved when the progress was asked for, and those that it says are left.
struct Told {
  double solved = 0.0, left = 0.0;
};

struct Progressed {
  std::vector<Told> all;
  test::Played run;
};

Progressed progress_of(const sim::Problem& problem) {
  Progressed told;
  sim::Observer observer;
  observer.progress = [&](const sim::Progress& p) { told.all.push_back({p.solved, p.to_be_solved}); };
  told.run = test::played(problem, observer);
  return told;
}

}  // namespace

// With fixed blocks the work left must be exact at every increment: what is solved and what is left adds up to the run.
TEST(Work, FixedBlocksAreExact) {
  const auto [all, run] = progress_of(test::problem_of(test::block_scene));
  const auto increments = static_cast<double>(run.summary.counts.increments);
  EXPECT_EQ(increments, 1.0 + 4 * 8);
  ASSERT_EQ(all.size(), 33u);
  for (const auto& told : all) EXPECT_EQ(told.solved + told.left, increments);
}

// Under a tolerance the work left must be right within a factor of three from the first block to the last but one, so
// that the time left that is shown never grows tenfold.
TEST(Work, ToleranceWithinAFactor) {
  for (const std::string jump :
       {"{ tolerance = 0.03 }", "{ tolerance = 0.01 }", "{ tolerance = 0.003, first = 500 }"}) {
    const auto [all, run] = progress_of(test::worn_block(jump));
    const auto total = static_cast<double>(run.summary.counts.increments);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [solved, left] : all) {
      if (solved < 1.0 + 3 * 8 || total - solved < 8 * 8) continue;  // the first block; the last one
      EXPECT_LT(std::abs(std::log(left / (total - solved))), std::log(3.0))
          << jump << " at " << solved << " of " << total;
      EXPECT_LT(left, 10.0 * least) << jump << " at " << solved;
      least = std::min(least, left);
    }
    EXPECT_EQ(all.back().solved, total);
  }
}

// A limit that ends the run shortens what is left: within a factor of two of what is then played.
TEST(Work, LimitsEndTheRun) {
  for (const bool stop : {false, true}) {
    const auto problem =
        test::worn_block("1000", std::string("[limit.life]\ncontact = \"pad\"\ndepth_mm = 1.0e-4\nstop = ") +
                                     (stop ? "true\n" : "false\n"));
    std::vector<double> left;
    sim::Observer observer;
    observer.block = [&](const sim::State& state) { left.push_back(sim::work_left(problem, state).blocks); };
    const auto run = test::played(problem, observer);
    const double played = static_cast<double>(run.summary.counts.blocks) - 6.0;  // after the load step and five blocks
    EXPECT_TRUE(stop || left.at(5) == played) << left.at(5);
    EXPECT_LT(std::abs(std::log(left.at(5) / played)), std::log(2.0)) << left.at(5) << " for " << played;
  }
}

// A run that the trial plays to its end is known; one that fails has no time but a reason.
TEST(Forecast, OfShortAndFailingRuns) {
  sim::Cache cache;
  const auto whole = sim::forecast(test::problem_of(test::block_scene), cache, 60.0, 0.5);
  EXPECT_TRUE(whole.whole);
  EXPECT_EQ(whole.increments, 33.0);
  EXPECT_EQ(whole.blocks, 5.0);
  EXPECT_EQ(whole.cycles, 4.0);
  EXPECT_NEAR(whole.seconds, 0.5 + whole.trial_seconds, 1e-12);
  sim::Cache other;
  const auto failing = sim::forecast(
      test::problem_of(test::with(test::block_scene, {{"motion_mm = 0.01", "motion_mm = 100.0"}})), other, 60.0, 0.0);
  EXPECT_TRUE(sim::in_words(failing).front().starts_with("time: unknown; the run fails")) << failing.unknown;
}

// A trial that is shorter than the run must judge it from what it has played.
TEST(Forecast, FromTheBeginning) {
  sim::Cache cache;
  const auto f = sim::forecast(test::worn_block("10"), cache, 0.02, 0.0);
  EXPECT_FALSE(f.whole);
  EXPECT_EQ(f.increments, 1.0 + 8 * 4000);
  EXPECT_GE(f.trial_increments, 1.0);
  const double pace = f.trial_seconds / f.trial_increments;
  EXPECT_GE(f.seconds, pace * f.increments);
  EXPECT_LE(f.seconds, 1.5 * pace * f.increments);
}
