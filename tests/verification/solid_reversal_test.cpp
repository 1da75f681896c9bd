#include <gtest/gtest.h>

#include "support/solid_slip_limit.hpp"

using namespace reye;

namespace {

/// Mean of the iterations of the increments in which one of the balls wears; none of them was cut back.
double mean_iterations(const support::SlipLimitCase& c) {
  const auto run = support::play_slip_limit(c);
  EXPECT_EQ(run.played.summary.status, sim::RunStatus::done) << run.played.summary.reason;
  EXPECT_EQ(run.played.summary.counts.cutbacks, 0);
  double iterations = 0.0, increments = 0.0;
  for (const auto& row : run.played.rows) {
    if (row.cycle == 0.0) continue;  // the press and the first push
    iterations += row.newton;
    increments += 1.0;
  }
  EXPECT_GE(increments, 12.0);
  return iterations / increments;
}

}  // namespace

// What slips and is turned back by a force, half a swing in two increments, must settle in at most ten iterations an
// increment in the mean, without a cut-back: it begins in stick, where the natural start would be far away.
TEST(SolidReversal, AForceThatTurnsBackTakesTenIterationsAnIncrement) {
  support::SlipLimitCase c;
  c.elements = 6.0;
  c.way = 1.0;
  c.jump = 5.0;
  c.increments = 4;
  EXPECT_LE(mean_iterations(c), 10.0);
}

// Near full slip the natural start begins close and then goes astray: it must be given up there, not after all of its
// thirty iterations.
TEST(SolidReversal, AStartThatGoesAstrayIsGivenUp) {
  support::SlipLimitCase c;
  c.q = 0.75;
  c.elements = 6.0;
  c.fine = 1.4;
  c.layer = 0.25;
  c.way = 0.3;
  c.jump = 2.0;
  c.increments = 4;
  EXPECT_LE(mean_iterations(c), 12.0);
}
