#include <gtest/gtest.h>

#include <algorithm>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/measure/limits.hpp"
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

// A life at which the measure begins to grow ten times as fast, or as slowly, must be found by blocks that end at it
// within two per cent or its stated error, wherever in a block it is; where the measure grows evenly no block is
// repeated.
TEST(Limits, GrowthThatChangesAtOnce) {
  scene::Limit limit;
  limit.name = "through";
  limit.depth_mm = 0.05;
  constexpr double slow = 1e-4, before = 0.01;
  for (const double faster : {10.0, 1.0, 0.1})
    for (int k = 1; k < 20; ++k) {
      const double life = 100.0 + (0.05 - before) / slow, block = 20.0 * (life - 100.0) / k;
      const auto depth = [&](double cycle) {
        return cycle < life ? before + slow * (cycle - 100.0) : 0.05 + faster * slow * (cycle - life);
      };
      std::map<std::string, double> lives, errors, measure{{"through", before}}, rate{{"through", slow}};
      const sim::Lives known{lives, errors, measure, rate};
      sim::LimitSpan span{100.0, 100.0 + block, 0.0};
      const auto middle = [&] {
        return std::map<std::string, double>{{"through", depth(0.5 * (span.before + span.after))}};
      };
      const auto end = [&] { return std::map<std::string, double>{{"through", depth(span.after)}}; };
      for (int turn = 0; turn < 4; ++turn) {
        const auto shorter = sim::end_at_limit({limit}, end(), span, middle(), 0.02, turn > 0, known);
        if (!shorter) break;
        EXPECT_NE(faster, 1.0) << k;
        EXPECT_FALSE(shorter->stop);
        span.after = span.before + shorter->share * (span.after - span.before);
      }
      sim::note_limits({limit}, end(), span, middle(), known);
      if (!lives.contains("through")) {
        span = {span.after, span.after + block, 0.0};
        sim::note_limits({limit}, end(), span, middle(), known);
      }
      EXPECT_NEAR(lives.at("through"), life, std::max(0.021 * life, errors.at("through"))) << faster << ' ' << k;
      EXPECT_LT(errors.at("through"), 0.06 * life) << faster << ' ' << k;
    }
}

// The life of a coating must be found within its stated error wherever blocks begin and end, and the log say which
// block was repeated.
TEST(Limits, ACoatingWornThroughInsideABlock) {
  const auto coated = [](const std::string& jump) {
    return recorded(test::problem_of(
        test::with(test::block_scene,
                   {{"secondary_mm3_per_J = 3.0e-5", "secondary_mm3_per_J = \"depth_mm < 5e-5 ? 3.0e-6 : 3.0e-5\""},
                    {", primary_mm3_per_J = 2.0e-5", ""},
                    {"cycles = 40\njump = 10", "cycles = 400000\njump = " + jump}}) +
        "[limit.through]\ncontact = \"pad\"\ndepth_mm = 5.5e-5\n" + test::few_frames));
  };
  const double exact =
      coated("{ tolerance = 0.2, first = 500, most = 4000 }").summary.life_cycles.at("through").value();
  int again = 0;
  for (const std::string first : {"400", "1000", "1700", "3000"}) {
    const auto r = coated("{ tolerance = 0.02, first = " + first + " }");
    const double life = r.summary.life_cycles.at("through").value(), error = r.summary.life_error.at("through");
    EXPECT_NEAR(life, exact, std::min(error, 0.01 * exact)) << first;
    EXPECT_LT(error, 0.03 * exact) << first;
    for (const auto& line : r.log) again += line.find("to end at limit through") != line.npos;
  }
  EXPECT_GT(again, 0);
}
