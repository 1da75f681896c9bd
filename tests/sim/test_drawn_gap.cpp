#include <gtest/gtest.h>

#include <functional>

#include "base/errors.hpp"
#include "played.hpp"
#include "problem_of.hpp"
#include "sim/measure/drawn_gap.hpp"
#include "sim/problem/drive.hpp"
#include "sim/study/run.hpp"
#include "support/texts.hpp"

using namespace reye;
using support::holds;
using test::Changes;

namespace {

/// The two blocks drawn `depth` into one another, with elements of 0.1 mm.
sim::Problem overlapping(double depth, Changes changes = {}) {
  changes.insert(changes.end(), {{"[body.slider]\n", "[body.slider]\nkinematics = \"small\"\n"},
                                 {"far_size_mm = 0.5", "far_size_mm = 0.1"},
                                 {"[body.base]\n", "[body.base]\nkinematics = \"small\"\n"},
                                 {"far_size_mm = 0.4", "far_size_mm = 0.1"}});
  return test::problem_of(test::with(test::block_scene, changes), -depth);
}

/// The upper block held or moved instead of loaded, with no stroke.
Changes moved_by(const std::string& way) {
  return {
      {"motion_mm = 0.01", "motion_mm = 0.0"},
      {"force_N_per_mm = -20.0", "motion_mm = " + way},
      {"friction  = 0.3\nwear      = { law = \"energy\", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5 }\n",
       ""},
      {"cycles = 40\njump = 10\n", "wear = false\n"}};
}

std::string refusal_of(const std::function<void()>& prepare) {
  try {
    prepare();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// A run that is done, and the force on its upper support per increment.
struct Closed : test::Played {
  std::vector<double> force{};
};

Closed closed(const sim::Problem& problem) {
  Closed c{test::recorded(problem)};
  for (const auto& row : c.rows) c.force.push_back(row.support_forces[0].y());
  return c;
}

}  // namespace

// Gap and overlap of every contact must be measured on the drawing, and sides that touch have neither.
TEST(DrawnGap, IsMeasured) {
  const auto apart = test::problem_of(test::block_scene, 0.1).contacts[0].drawn;
  EXPECT_NEAR(apart.gap_mm, 0.1, 1e-12);
  EXPECT_EQ(apart.overlap_mm, 0.0);
  const auto touching = test::problem_of(test::block_scene).contacts[0].drawn;
  EXPECT_EQ(touching.gap_mm, 0.0);
  EXPECT_EQ(touching.overlap_mm, 0.0);
  const auto inside = overlapping(0.25).contacts[0].drawn;
  EXPECT_EQ(inside.gap_mm, 0.0);
  EXPECT_NEAR(inside.overlap_mm, 0.25, 1e-12);
  EXPECT_TRUE(inside.let_in);
}

// The plan must say how large a gap or an overlap is, and in which step it is let in.
TEST(DrawnGap, IsInThePlan) {
  EXPECT_EQ(overlapping(0.25).plan.lines[3],
            "contact pad: drawn overlap of 0.25 mm, at (1, -0.25) mm, let in over the 1 increment of step \"press\"");
  EXPECT_EQ(test::problem_of(test::block_scene, 0.1).plan.lines[3], "contact pad: drawn gap of 0.1 mm, at (1, 0.1) mm");
}

// What is less than a twentieth of a facet must change neither steps nor histories: facets of curves that touch overlap
// so.
TEST(DrawnGap, ATinyOverlapIsClosedAtOnce) {
  const auto problem = overlapping(0.004);
  EXPECT_FALSE(problem.contacts[0].drawn.let_in);
  EXPECT_EQ(problem.scene.steps[0].play, std::vector<std::string>{"press"});
  EXPECT_FALSE(problem.scene.histories.contains(sim::overlap_left));
}

// An overlap must be let in by progress alone: half way through the step half of it is left, whatever increments there
// are.
TEST(DrawnGap, IsLetInByProgress) {
  const auto problem = overlapping(0.25);
  auto state = sim::initial_state(problem);
  sim::Cache cache;
  const auto kept = sim::system_of(problem, state, cache);
  const auto& system = *kept;
  for (double progress : {0.0, 0.5, 1.0}) {
    const auto& step = problem.scene.steps[0];
    const auto factors = sim::factors_at(problem.scene.histories, step, progress, state.factors);
    EXPECT_NEAR(sim::controls_at(problem, system, factors, step, 0.0, progress, 1.0).contacts[0].inset,
                0.25 * (1.0 - progress), 1e-15);
  }
}

// Blocks drawn into one another must be pressed as by a motion of that size: at its end the same, on the way but for
// the dent that the side lies inside of.
TEST(DrawnGap, ActsAsTheMotionDoes) {
  const Changes ramp = {{"wear = false", "increments = 4\nwear = false"}};
  auto drawn = moved_by("0.0"), moved = moved_by("-0.25");
  drawn.insert(drawn.begin(), ramp[0]);
  moved.insert(moved.begin(), ramp[0]);
  const auto in = closed(overlapping(0.25, drawn)), by_motion = closed(overlapping(0.0, moved));
  ASSERT_EQ(in.force.size(), by_motion.force.size());
  EXPECT_LT(in.force[3], -1e4);
  for (std::size_t k = 0; k < in.force.size(); ++k)
    EXPECT_NEAR(in.force[k], by_motion.force[k], (k < 3 ? 5e-3 : 1e-9) * std::abs(in.force[k]));
}

// A body that a force holds must be lifted out of an overlap, and carry that force alone.
TEST(DrawnGap, ABodyUnderAForceIsLiftedOut) {
  const auto in = closed(overlapping(0.25)), touching = closed(overlapping(0.0));
  EXPECT_NEAR(in.force[0], touching.force[0], 1e-6 * 20.0);
  EXPECT_NEAR(in.summary.contacts[0].normal_force, touching.summary.contacts[0].normal_force, 1e-6 * 20.0);
}

// A first step that counts cycles must begin with the overlap let in, in a step of its own which wears nothing.
TEST(DrawnGap, IsLetInBeforeCycles) {
  const auto problem =
      overlapping(0.1, {{"[[step]]\nname = \"press\"\nplay = [\"press\"]\nwear = false\n", ""},
                        {"force_N_per_mm = -20.0, history = \"press\"", "motion_mm = 0.0, history = \"press\""},
                        {"friction  = 0.3", "friction  = 0.01"},
                        {"motion_mm = 0.01", "motion_mm = 0.1"}});
  ASSERT_EQ(problem.scene.steps.size(), 2U);
  EXPECT_FALSE(problem.scene.steps[0].wear);
  EXPECT_EQ(problem.scene.steps[0].cycles, 0.0);
  auto state = sim::initial_state(problem);
  sim::Observer watch;
  std::vector<double> worn;
  watch.increment = [&](const sim::IncrementRecord& i) { worn.push_back(i.depth_max_secondary_mm); };
  const auto summary = sim::run(problem, state, watch);
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_EQ(summary.cycles, 40.0);
  EXPECT_EQ(worn[9], 0.0);
  EXPECT_GT(worn.back(), 0.0);
}

// What slips while an overlap is let in must wear by coefficient x work where the step wears, and not where it does
// not.
TEST(DrawnGap, WearsByItsWorkAlone) {
  for (bool wears : {false, true}) {
    const auto problem =
        overlapping(0.1, {{"wear = false", wears ? "increments = 4" : "increments = 4\nwear = false"},
                          {"force_N_per_mm = -20.0, history = \"press\"", "motion_mm = 0.0, history = \"press\""},
                          {"cycles = 40\njump = 10\n", "wear = false\n"}});
    const auto r = closed(problem);
    const auto& contact = r.state.solution.contacts[0];
    EXPECT_EQ(contact.law_volume > 0.0, wears);
    const double removed = contact.strip_secondary + contact.strip_primary;
    EXPECT_NEAR(removed, contact.law_volume, 1e-9 * removed);
  }
}

// An overlap of half a body is no fit: it must be refused with contact, depth and body, and what to change.
TEST(DrawnGap, OfHalfABodyIsRefused) {
  const auto text = refusal_of([] { test::problem_of(test::block_scene, -0.5); });
  EXPECT_TRUE(holds(text, "contact.pad: its sides overlap by 0.5 mm as drawn")) << text;
  EXPECT_TRUE(holds(text, "of the 1 mm that body slider measures there: too deep for a fit; draw the bodies apart"))
      << text;
}

// Bodies drawn farther apart than the usual search must come together where a motion or a force brings them together.
TEST(DrawnGap, IsClosedByWhatDrivesTheBodies) {
  auto changes = moved_by("-1.001");
  changes.push_back({"wear = false", "increments = 4\nwear = false"});
  EXPECT_LT(closed(test::problem_of(test::with(test::block_scene, changes), 1.0)).force[3], -10.0);
  EXPECT_NEAR(closed(test::problem_of(test::block_scene, 1.0)).summary.contacts[0].normal_force, 20.0, 1e-3);
}

// Where nothing does, the refusal must name the gap and the largest motion.
TEST(DrawnGap, ThatNothingClosesIsRefused) {
  const auto text = refusal_of([] { test::problem_of(test::with(test::block_scene, moved_by("-0.5")), 1.0); });
  EXPECT_TRUE(holds(text, "the sides are 1 mm apart as drawn, and supports move these bodies by 0.5 mm at most"))
      << text;
}

// A gap that nothing in the scene can close must be reported before the run, with both lengths.
TEST(DrawnGap, ThatNothingClosesIsTold) {
  const auto problem = test::problem_of(test::with(test::block_scene, moved_by("-0.05")), 0.1);
  ASSERT_EQ(problem.warnings.size(), 1U);
  EXPECT_EQ(problem.warnings[0].kind, "gap");
  EXPECT_EQ(problem.warnings[0].text,
            "Its sides are 0.1 mm apart as drawn, and supports move no body by more than 0.05 mm, nor does a force: "
            "they never "
            "touch. Draw them closer, or move them farther.");
  EXPECT_TRUE(test::problem_of(test::with(test::block_scene, moved_by("-0.2")), 0.1).warnings.empty());
}
