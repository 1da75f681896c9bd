#include <cmath>

#include "wear_scene.hpp"

using namespace reye;
using verification::Played;
using verification::played;
using verification::scene_text;

namespace {

/// A cylinder that frets on a flat, in blocks of so many cycles, with frames at the start and the end of steps.
Played fretting(const std::string& jump, const std::string& more = "") {
  return played(scene_text("fretting_demo", {{"jump = { tolerance = 0.01 }", "jump = " + jump},
                                             {"every_cycles = 1800", "per_step = 0"},
                                             {"increments = 40", "increments = 24"}}) +
                more);
}

/// What the run says of pressures that its blocks leave uneven; 0: nothing.
double said(const Played& run) {
  for (const auto& warning : run.summary.warnings)
    if (warning.kind == "pressures" && warning.about == "step wear") return warning.severity;
  return 0.0;
}

/// Root mean square of the difference of pressures at the end over that of the second run.
double apart(const Played& a, const Played& b) {
  const auto &p = a.surface(sim::Side::secondary).pressure_MPa, &q = b.surface(sim::Side::secondary).pressure_MPa;
  EXPECT_EQ(p.size(), q.size());
  double difference = 0.0, all = 0.0;
  for (std::size_t j = 0; j < p.size(); ++j) {
    difference += (p[j] - q[j]) * (p[j] - q[j]);
    all += q[j] * q[j];
  }
  return std::sqrt(difference / all);
}

/// A rivet that yields in its first loading and frets over 40 cycles, in blocks of so many.
Played rivet(const std::string& jump) {
  return played(scene_text("switch_rivet", {{"size_mm = 0.010", "size_mm = 0.03"},
                                            {"increments = 20", "increments = 8"},
                                            {"increments = 40", "increments = 16"},
                                            {"cycles = 10000", "cycles = 40"},
                                            {"jump = { tolerance = 0.01 }", "jump = " + jump}}));
}

}  // namespace

// A body that yields wears in its first cycles as in no later one: blocks of a fixed jump must not take them for all
// of their cycles. (Without parts of the first block the worn area is 4.1 % off.)
TEST(FixedJump, FirstCyclesOfARivetStandForThemselves) {
  const auto jumped = rivet("20"), singly = rivet("1");
  EXPECT_EQ(jumped.summary.counts.cycles_solved, 7);
  EXPECT_EQ(singly.summary.counts.cycles_solved, 40);
  const double off = jumped.contact().secondary.worn_area / singly.contact().secondary.worn_area - 1.0;
  EXPECT_LT(std::abs(off), 0.005) << off;
}

// Blocks of one size so long that their first strokes wear other places than the last ones must say how far pressures
// may be off, and shorter ones, or a tolerance, nothing; the cycle that is played to find out leaves no wear, no cycle
// and no count.
TEST(FixedJump, LongBlocksSayWhatPressuresAreOffBy) {
  const auto fine = fretting("100"), coarse = fretting("600"), controlled = fretting("{ tolerance = 0.01 }");
  const double off = apart(coarse, fine);
  EXPECT_GT(off, 0.1);
  EXPECT_GT(2.0 * said(coarse), off);
  EXPECT_LT(said(coarse), off);
  EXPECT_EQ(said(fine), 0.0);
  EXPECT_EQ(said(controlled), 0.0);
  EXPECT_LT(apart(controlled, fine), 0.06);
  EXPECT_EQ(coarse.summary.cycles, 18000.0);
  EXPECT_EQ(coarse.summary.counts.cycles_solved, 30);
  EXPECT_EQ(coarse.records.back().cycle, 18000.0);
  EXPECT_LT(coarse.contact().ledger_relative_error.value(), 1e-12);
}

// Where the last block ends on a fresh mesh its blocks must be judged as those of a run that keeps its mesh are.
TEST(FixedJump, AFreshMeshAtTheEndHidesNothing) {
  const auto kept = fretting("1800"), fresh = fretting("1800", "[remesh]\nevery_blocks = 10\n");
  EXPECT_EQ(kept.summary.counts.remeshes, 0);
  ASSERT_EQ(fresh.records.back().cycle, 18000.0);
  ASSERT_EQ(fresh.summary.counts.remeshes, 2);
  EXPECT_GT(said(kept), 0.1);
  EXPECT_NEAR(said(fresh) / said(kept), 1.0, 0.5);
}
