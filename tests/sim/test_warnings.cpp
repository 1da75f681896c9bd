#include "sim/problem/warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/march/watch_block.hpp"
#include "sim/study/run.hpp"

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

// Plastic strain that grew in a cycle which stands for many must be reported, with its growth; nothing is missing where
// every cycle is played, nor once the strain has settled.
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
  EXPECT_NE(warnings[0].text.find("from 0.01 to 0.011 in cycles that stand for 30 each"), std::string::npos)
      << warnings[0].text;
  EXPECT_TRUE(told(0.010, 0.011, 1.0).empty());
  EXPECT_TRUE(told(0.011, 0.011, 30.0).empty());
}

// A tolerance that was missed must be reported with both figures, one that was held must not.
TEST(Warnings, MissedTolerance) {
  const auto told = [](double error) {
    scene::Step step;
    step.name = "wear";
    step.jump_tolerance = 0.01;
    State state;
    state.jump_error = error;
    watch_tolerance(step, state, {});
    return state.warnings;
  };
  const auto warnings = told(0.015);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind + ", " + warnings[0].about, "tolerance, step wear");
  EXPECT_NE(warnings[0].text.find("is 1.5 %, above the tolerance of 1 %"), std::string::npos) << warnings[0].text;
  EXPECT_TRUE(told(0.0099).empty());
}

struct Warned {
  Summary summary;
  test::Kinds kinds;
};

Warned warned(const test::Changes& changes) {
  const auto r = test::played(test::problem_of(test::with(test::block_scene, changes)));
  return {r.summary, test::kinds_of(r.summary.warnings)};
}

// A run whose cycles are jumped while plastic strain still grows must say so among its warnings; one that plays every
// cycle has nothing to say.
TEST(Warnings, RunWithJumpedPlasticCycles) {
  const auto of = [](const std::string& cycles) {
    return warned(
        {{"E_MPa = 200e3",
          "law = \"hencky_j2\"\nhardening = { law = \"linear\", yield_MPa = 8.0, modulus_MPa = 2000.0 }\nE_MPa "
          "= 200e3"},
         {"force_N_per_mm = -20.0", "force_N_per_mm = -36.0"},
         {"friction  = 0.3", "friction  = 0.6"},
         {"cycles = 40\njump = 10", cycles}});
  };
  const auto jumped = of("cycles = 20\njump = 10");
  EXPECT_EQ(jumped.summary.status, RunStatus::done) << jumped.summary.reason;
  const auto missing = [](const test::Kinds& kinds) { return std::ranges::count(kinds, "plastic, step wear"); };
  EXPECT_EQ(missing(jumped.kinds), 1);
  EXPECT_EQ(missing(of("cycles = 20\njump = 1").kinds), 0);
}

// Strain beyond 1 % in bodies that small strain was not written for must be warned of, beyond 5 % end the run; where it
// was written it is warned of, and no more. Strain is p / E': 10 MPa on 500 MPa are 2 %, on 100 MPa 10 %.
TEST(Warnings, StrainOfSmallStrain) {
  const auto of = [](const std::string& modulus, const std::string& written) {
    return warned({{"E_MPa = 200e3", "E_MPa = " + modulus},
                   {"[body.slider]\n", "[body.slider]\n" + written},
                   {"[body.base]\n", "[body.base]\n" + written},
                   {"motion_mm = 0.01", "motion_mm = 0.0"},
                   {"cycles = 40\njump = 10", "wear = false"}});
  };
  const test::Kinds both{"strain, body slider", "strain, body base"};
  const auto stiff = of("200e3", ""), soft = of("500.0", ""), softer = of("100.0", ""),
             asked = of("100.0", "kinematics = \"small\"\n");
  EXPECT_EQ(stiff.kinds, test::Kinds{});
  EXPECT_EQ(soft.summary.status, RunStatus::done);
  EXPECT_EQ(soft.kinds, both);
  EXPECT_EQ(softer.summary.status, RunStatus::failed);
  EXPECT_NE(softer.summary.reason.find("the error of small strain in that is about"), std::string::npos)
      << softer.summary.reason;
  EXPECT_EQ(asked.summary.status, RunStatus::done);
  EXPECT_EQ(asked.kinds, both);
}

}  // namespace
