#include <gtest/gtest.h>

#include <algorithm>

#include "support/solid_slip_limit.hpp"

/// What a run of solids says of a stick zone that forces alone drive.
namespace reye::verification {

namespace {

/// Two cycles of a ball that wears at half of the force that slips.
support::SlipLimitCase two_cycles(double elements) {
  return {.elements = elements, .way = 0.1, .jump = 1.0, .increments = 2};
}

long count_of(const sim::SolidSummary& summary, const std::string& kind) {
  return std::count_if(summary.warnings.begin(), summary.warnings.end(),
                       [&](const sim::Warning& w) { return w.kind == kind; });
}

}  // namespace

// An edge is known to one element: a run whose depth in the end hangs on it must say so.
TEST(SolidStickEdge, FewElementsAreReported) {
  const auto c = two_cycles(4.0);
  const auto run = support::play_slip_limit(c);
  ASSERT_EQ(run.played.summary.status, sim::RunStatus::done) << run.played.summary.reason;
  EXPECT_EQ(count_of(run.played.summary, "stick_elements"), 1);
  EXPECT_EQ(count_of(run.played.summary, "stick_zone"), 0);
}

// A motion that is prescribed may slide a body as a whole and keeps no width of a stick zone: nothing is to be said.
TEST(SolidStickEdge, MotionsKeepNoWidth) {
  auto problem = two_cycles(4.0).problem();
  for (auto& input : problem.inputs)
    for (auto& support : input.supports)
      for (auto& motion : support.along)
        if (!motion.parts.empty() && motion.parts.front().history == "slide") {
          motion.drive = body::Drive::moved;
          for (auto& part : motion.parts) part.value = 2e-4;
        }
  const auto run = support::play(problem);
  ASSERT_EQ(run.summary.status, sim::RunStatus::done) << run.summary.reason;
  EXPECT_EQ(count_of(run.summary, "stick_elements"), 0);
}

}  // namespace reye::verification
