#include <gtest/gtest.h>

#include "support/solid_slip_limit.hpp"

using namespace reye;

namespace {

/// Mean of the iterations of the so many increments in which one of the balls wears; none of them was cut back.
double mean_iterations(const support::SlipLimitCase& c, std::size_t increments) {
  const auto run = support::play_slip_limit(c);
  EXPECT_EQ(run.played.summary.status, sim::RunStatus::done) << run.played.summary.reason;
  EXPECT_EQ(run.played.summary.counts.cutbacks, 0);
  constexpr std::size_t before = 3;  // increments of the press and the first push
  const auto& rows = run.played.rows;
  EXPECT_EQ(rows.size(), before + increments);
  double iterations = 0.0;
  for (std::size_t k = before; k < rows.size(); ++k) iterations += rows[k].newton;
  return iterations / static_cast<double>(increments);
}

}  // namespace

// What slips and is turned back by a force, half a swing in two increments, must settle in at most ten iterations an
// increment in the mean, without a cut-back: it begins in stick, where the natural start would be far away.
TEST(SolidReversal, AForceThatTurnsBackTakesTenIterationsAnIncrement) {
  EXPECT_LE(mean_iterations({.elements = 6.0, .way = 1.0, .jump = 5.0, .increments = 4}, 16), 10.0);
}

// Near full slip the natural start begins close and then goes astray: it must be given up there, not after all of its
// thirty iterations.
TEST(SolidReversal, AStartThatGoesAstrayIsGivenUp) {
  const support::SlipLimitCase c{
      .q = 0.75, .elements = 6.0, .fine = 1.4, .layer = 0.25, .way = 0.3, .jump = 2.0, .increments = 4};
  EXPECT_LE(mean_iterations(c, 12), 10.0);  // 7.7
}
