#include "sim/measure/warn_contact.hpp"
#include "sim/study/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "disc_scene.hpp"
#include "played.hpp"

using namespace reye;
using test::Kinds;
using test::kinds_of;
using test::played;

namespace {

/// What a run warns of, all before it aside.
Kinds found(sim::Problem problem) {
  problem.warnings.clear();
  const auto r = played(problem);
  EXPECT_EQ(r.summary.status, sim::RunStatus::done) << r.summary.reason;
  return kinds_of(r.summary.warnings);
}

Kinds found_of_blocks(const test::Changes& changes, double gap = 0.0) {
  return found(test::problem_of(test::with(test::block_scene, changes), gap));
}

const std::string many_cycles = "cycles = 40\njump = 10", few_cycles = "cycles = 20\njump = 10";

}  // namespace

// A contact that is resolved, and one that ends where the bodies end, must give no warning.
TEST(WarnContact, NothingWithoutCause) {
  EXPECT_EQ(found(test::disc_problem()), Kinds{});
  EXPECT_EQ(found_of_blocks({{many_cycles, few_cycles}}), Kinds{});
}

// A warning must be given for some three elements across a contact, with their number.
TEST(WarnContact, ElementsAcross) {
  auto problem = test::disc_problem({{"size_mm = 0.005", "size_mm = 0.02"}});
  EXPECT_EQ(found(problem), Kinds{"resolution, contact pad"});
  problem.warnings.clear();
  const auto warning = played(problem).summary.warnings.at(0);
  EXPECT_NEAR(warning.severity, 8.0 / 3.0, 8.0 / 3.0 - 8.0 / 4.0 + 1e-9);
}

// A contact that runs to the end of its named boundary, while the outline continues straight, must be reported with the
// name.
TEST(WarnContact, EndOfANamedBoundary) {
  auto problem = test::disc_problem({}, "0.01");
  problem.warnings.clear();
  const auto warnings = played(problem).summary.warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, "boundary_end");
  EXPECT_NE(warnings[0].text.find("the end of face"), std::string::npos) << warnings[0].text;
}

// A contact that carries most of its load beside its fine zone must be reported.
TEST(WarnContact, BesideTheFineZone) {
  const auto kinds = found(test::disc_problem({{"centre_mm = [0.0, 0.0]", "centre_mm = [0.4, 0.0]"}}, "0.9"));
  EXPECT_NE(std::find(kinds.begin(), kinds.end(), "fine_zone, contact pad"), kinds.end());
}

// A contact that never touched must be reported; nothing is said then of its wear.
TEST(WarnContact, NeverClosed) {
  EXPECT_EQ(found_of_blocks(
                {{many_cycles, few_cycles},
                 {"{ force_N_per_mm = -20.0, history = \"press\" }", "{ motion_mm = -0.001, history = \"press\" }"}},
                0.01),
            Kinds{"never_closed, contact pad"});
}

// A contact that should wear but sticks throughout must be reported, with the stroke that was asked for.
TEST(WarnContact, NothingSlipped) {
  auto problem = test::problem_of(
      test::with(test::block_scene, {{many_cycles, few_cycles}, {"motion_mm = 0.01", "motion_mm = 1e-8"}}));
  const auto warnings = played(problem).summary.warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, "no_slip");
  EXPECT_NE(warnings[0].text.find("up to 1e-08 mm"), std::string::npos) << warnings[0].text;
}

// A limit on the side that wears a twentieth must be reported, unless another limit watches the other side.
TEST(WarnContact, LimitOfTheMilderSide) {
  const std::string limit = "[limit.life]\ncontact = \"pad\"\ndepth_mm = 1.0\n";
  const std::string other = "[limit.other]\ncontact = \"pad\"\nside = \"primary\"\ndepth_mm = 1.0\n";
  const std::pair<std::string, std::string> mild{"secondary_mm3_per_J = 3.0e-5", "secondary_mm3_per_J = 1.0e-6"};
  EXPECT_EQ(found_of_blocks({{many_cycles, few_cycles}, mild, {"[history]", limit + "[history]"}}),
            Kinds{"limit_side, limit life"});
  EXPECT_EQ(found_of_blocks({{many_cycles, few_cycles}, mild, {"[history]", limit + other + "[history]"}}), Kinds{});
}

// A ledger that does not close must be reported with its figure; what rounding leaves of next to nothing must not.
TEST(WarnContact, OpenLedger) {
  const auto problem = test::problem_of(test::block_scene);
  const auto told = [&](double area, double error) {
    sim::State state;
    sim::Summary summary;
    summary.contacts.resize(1);
    summary.contacts[0].name = "pad";
    summary.contacts[0].secondary.worn_area = area;
    summary.contacts[0].ledger_relative_error = error;
    sim::warn_of_run(problem, state, summary, {});
    return kinds_of(state.warnings);
  };
  EXPECT_EQ(told(1e-3, 2e-3), Kinds{"ledger, contact pad"});
  EXPECT_EQ(told(1e-3, 1e-9), Kinds{});
  EXPECT_EQ(told(1e-20, 2e-3), Kinds{});
}

// A fresh mesh that changed the pressure by more than a tenth must be reported, one that did not must not.
TEST(WarnContact, JumpAtARemesh) {
  sim::State state;
  sim::RemeshRecord record;
  record.body = "pad";
  record.pressure_jump = 0.09;
  sim::warn_of_remesh(state, {}, record);
  EXPECT_TRUE(state.warnings.empty());
  record.pressure_jump = 0.3;
  sim::warn_of_remesh(state, {}, record);
  ASSERT_EQ(state.warnings.size(), 1u);
  EXPECT_EQ(state.warnings[0].kind + ", " + state.warnings[0].about, "remesh, body pad");
}
