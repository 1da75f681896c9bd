#include <gtest/gtest.h>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/study/run.hpp"

using namespace reye;
using test::played;

namespace {

/// The upper of two blocks of rubber, 0.1 mm apart, pushed down by 0.6 mm in one increment.
std::string pushed(const std::string& more) {
  return test::with(test::block_scene, {{"E_MPa = 200e3", "E_MPa = 5.0"},
                                        {"[body.slider]\n", "[body.slider]\nkinematics = \"small\"\n"},
                                        {"[body.base]\n", "[body.base]\nkinematics = \"small\"\n"},
                                        {"force_N_per_mm = -20.0", "motion_mm = -0.6"},
                                        {"motion_mm = 0.01", "motion_mm = 0.0"},
                                        {"wear = false\n", "wear = false\nincrements = 1\n"},
                                        {"cycles = 40\njump = 10\n", "cycles = 1\n"}}) +
         more;
}

}  // namespace

// An increment in which a body would pass through another must be cut until contact is seen, and then carry its load.
TEST(Passage, IsCutBack) {
  const auto r = played(test::problem_of(pushed(""), 0.1));
  EXPECT_EQ(r.summary.status, sim::RunStatus::done) << r.summary.reason;
  EXPECT_GE(r.summary.counts.cutbacks, 1);
  EXPECT_GT(r.summary.contacts.at(0).normal_force, 1.0);
}

// Where no cut-back is left the run must fail, and say what happened.
TEST(Passage, FailsWithItsReason) {
  const auto r = played(test::problem_of(pushed("[solver]\nmax_cutbacks = 0\n"), 0.1));
  EXPECT_EQ(r.summary.status, sim::RunStatus::failed);
  EXPECT_NE(r.summary.reason.find("went through the other side of contact pad"), std::string::npos) << r.summary.reason;
}
