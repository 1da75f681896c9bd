#include <gtest/gtest.h>

#include "support/solid_slip_limit.hpp"

using namespace reye;

// What slips and is turned back by a force, half a swing in two increments, must settle in at most ten iterations an
// increment in the mean, without a cut-back: it begins in stick, where the natural start would be far away.
TEST(SolidReversal, AForceThatTurnsBackTakesTenIterationsAnIncrement) {
  support::SlipLimitCase c;
  c.elements = 6.0;
  c.way = 1.0;
  c.jump = 5.0;
  c.increments = 4;
  const auto run = support::play_slip_limit(c);
  const auto& counts = run.played.summary.counts;
  ASSERT_EQ(run.played.summary.status, sim::RunStatus::done) << run.played.summary.reason;
  EXPECT_EQ(counts.cutbacks, 0);
  constexpr std::size_t before = 3;  // increments of the first push
  const auto& rows = run.played.rows;
  ASSERT_EQ(rows.size(), before + 16);
  double iterations = 0.0;
  for (std::size_t k = before; k < rows.size(); ++k) iterations += rows[k].newton;
  EXPECT_LE(iterations / 16.0, 10.0);
}
