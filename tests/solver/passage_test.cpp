#include <gtest/gtest.h>

#include "solver/blocks.hpp"

/// Bodies that would pass through one another within one increment.
namespace {

using namespace reye;

/// The upper block 0.1 mm above the lower one, pushed down or aside in one increment.
solver::SolveResult pushed(double down, double aside = 0.0, bool upper_secondary = true, double search = 0.0,
                           double inset = 0.0) {
  auto a = support::blocks(
      {.friction = 0.3, .press = down, .drag = aside, .crown = 0.0, .upper_secondary = upper_secondary});
  for (auto& x : a.meshes[1].X) x.y() += 0.1;
  a.touches[0].options.search_mm = search;
  const auto system = support::system_of(a);
  auto controls = support::controls_of(a, system);
  controls.contacts[0].inset = inset;
  return solver::Newton().solve(system, support::fresh(system), controls);
}

// A push that takes one side behind the other, farther than the integrals see, must not be accepted as free of contact.
TEST(passage, an_overlap_that_no_integral_saw_is_refused) {
  for (bool upper_secondary : {false, true}) {
    const auto result = pushed(0.6, 0.0, upper_secondary);
    EXPECT_FALSE(result.report.converged);
    EXPECT_NE(result.report.reason.find("went through the other side of contact"), std::string::npos)
        << result.report.reason;
  }
}

// Wholly through and out at the far side is no less an error.
TEST(passage, through_the_whole_body) { EXPECT_FALSE(pushed(1.5).report.converged); }

// What stays within the search must come into contact, and what never meets must stay free, however far it goes.
TEST(passage, contact_and_free_motion_are_accepted) {
  const auto touching = pushed(0.12);
  EXPECT_TRUE(touching.report.converged) << touching.report.reason;
  double pressure = 0.0;
  for (const auto& l : touching.state.contacts[0].lambda) pressure = std::max(pressure, l.norm());
  EXPECT_GT(pressure, 1.0);
  for (double aside : {5.0, -5.0}) EXPECT_TRUE(pushed(0.05, aside).report.converged);
  EXPECT_TRUE(pushed(-3.0).report.converged);
}

// A passage must be refused while a drawn overlap is let in, too.
TEST(passage, beyond_a_drawn_overlap) {
  const auto result = pushed(0.6, 0.0, true, 0.0, 0.05);
  EXPECT_FALSE(result.report.converged);
  EXPECT_NE(result.report.reason.find("went through the other side of contact"), std::string::npos)
      << result.report.reason;
}

// A slide far beyond the search along a closed contact must not be taken for a passage.
TEST(passage, a_long_slide_is_none) {
  const auto slid = pushed(0.1001, 0.12, true, 0.1);
  EXPECT_TRUE(slid.report.converged) << slid.report.reason;
}

}  // namespace
