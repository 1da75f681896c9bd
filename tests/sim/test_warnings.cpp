#include "sim/problem/warnings.hpp"

#include <gtest/gtest.h>

#include "sim/march/watch_block.hpp"

namespace {

using namespace reye;
using namespace reye::sim;

// Of one kind about one thing the most severe warning stays, in its first place; the log reports it once.
TEST(Warnings, TheMostSevereStays) {
  State state;
  std::vector<std::string> said;
  Observer observer;
  observer.log = [&](const std::string& text) { said.push_back(text); };
  warn(state, observer, {"strain", "body pin", "strain of 2 %", 0.02});
  warn(state, observer, {"overlap", "", "bodies overlap by 1 um", 1.0});
  warn(state, observer, {"strain", "body pin", "strain of 4 %", 0.04});
  warn(state, observer, {"strain", "body pin", "strain of 3 %", 0.03});
  warn(state, observer, {"strain", "body block", "strain of 3 %", 0.03});
  ASSERT_EQ(state.warnings.size(), 3u);
  EXPECT_EQ(state.warnings[0].text, "strain of 4 %");
  EXPECT_EQ(said, (std::vector<std::string>{"warning: strain, body pin: strain of 2 %",
                                            "warning: overlap: bodies overlap by 1 um",
                                            "warning: strain, body block: strain of 3 %"}));
}

// Plastic strain that grew in a cycle which stands for many must be reported, with what is missing; none is missing
// where every cycle is played, nor once the strain has settled.
TEST(Warnings, JumpedCyclesAddNoPlasticStrain) {
  const auto told = [](double before, double now, double cycles) {
    scene::Step step;
    step.name = "wear";
    State state;
    state.solution.interiors.resize(1);
    state.solution.interiors[0].history.resize(2);
    state.solution.interiors[0].history[1].accumulated = now;
    watch_plastic_strain(step, before, cycles, state, {});
    return state.warnings;
  };
  const auto warnings = told(0.010, 0.011, 30.0);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, "plastic");
  EXPECT_EQ(warnings[0].about, "step wear");
  EXPECT_NE(warnings[0].text.find("some 0.029 is missing"), std::string::npos) << warnings[0].text;
  EXPECT_TRUE(told(0.010, 0.011, 1.0).empty());
  EXPECT_TRUE(told(0.011, 0.011, 30.0).empty());
}

}  // namespace
