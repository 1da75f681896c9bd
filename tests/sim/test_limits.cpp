#include <gtest/gtest.h>

#include <algorithm>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/study/run.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;
using test::recorded;
using test::worn_block;

namespace {

const char* const stop_at_a_depth = "[limit.life]\ncontact = \"pad\"\ndepth_mm = 1.0e-4\nstop = true\n";

double deepest(const sim::IncrementRecord& row) { return row.depth_max_secondary_mm; }

}  // namespace

// A run that a limit stops must end where the limit is, by a tolerance and in fixed blocks, and its life be that cycle.
TEST(Limits, StopEndsTheRunAtTheLimit) {
  for (const std::string jump : {"{ tolerance = 0.01, first = 500 }", "5000"}) {
    const auto r = recorded(worn_block(jump, stop_at_a_depth));
    const double life = r.summary.life_cycles.at("life").value();
    EXPECT_NEAR(r.summary.cycles, life, 5e-3 * life) << jump;
    EXPECT_NEAR(r.summary.limit_share.at("life"), 1.0, 5e-3) << jump;
    EXPECT_LT(r.summary.cycles, 39000.0);
    EXPECT_TRUE(std::is_sorted(r.rows.begin() + 1, r.rows.end(),
                               [](const auto& a, const auto& b) { return a.cycle < b.cycle; }));
    EXPECT_LT(r.summary.contacts[0].ledger_relative_error.value(), 1e-12);
  }
}

// Where two limits would end the run, it must end at the first.
TEST(Limits, TheFirstOfTwoEndsTheRun) {
  const auto r = recorded(
      worn_block("{ tolerance = 0.01, first = 500 }",
                 std::string(stop_at_a_depth) + "[limit.sooner]\ncontact = \"pad\"\ndepth_mm = 0.5e-4\nstop = true\n"));
  EXPECT_NEAR(r.summary.cycles, r.summary.life_cycles.at("sooner").value(), 5e-3 * r.summary.cycles);
  EXPECT_FALSE(r.summary.life_cycles.at("life"));
}

// Under a tolerance the last row of the history must say what the summary says, and no row fall behind the one before.
TEST(Limits, HistoryEndsAsTheSummary) {
  const auto r = recorded(worn_block("{ tolerance = 0.03, first = 500 }"));
  EXPECT_NEAR(deepest(r.rows.back()), r.summary.contacts[0].secondary.max_depth_mm, 1e-12);
  EXPECT_NEAR(r.rows.back().energy_mJ, r.summary.contacts[0].dissipated_energy, 1e-9 * r.rows.back().energy_mJ);
  EXPECT_NEAR(r.rows.back().cycle, r.summary.cycles, 1e-6);
  EXPECT_TRUE(std::is_sorted(r.rows.begin(), r.rows.end(),
                             [](const auto& a, const auto& b) { return deepest(a) < deepest(b); }));
}

// A run must hold its tolerance by its own estimate, or be warned of with the figure: never is one missed in silence.
TEST(Limits, NoToleranceIsMissedInSilence) {
  const verification::Replacements words{
      {"[limit.life]\ncontact     = \"pad\"\ndepth_mm    = 1e-3\nstop        = true\nwear_factor = [0.5, 2.0]\n",
       "[remesh]\nautomatic = false\n"},
      {"cycles = 2000\njump = 100", "cycles = 300\njump = { tolerance = 0.01 }"}};
  const auto played = verification::played(verification::scene_text("life_band", words));
  const auto& warnings = played.summary.warnings;
  const bool warned =
      std::any_of(warnings.begin(), warnings.end(), [](const auto& w) { return w.kind == "tolerance"; });
  EXPECT_TRUE(warned || played.summary.error_cycle_jump.value() <= 0.01) << played.summary.error_cycle_jump.value();
}
