#include <gtest/gtest.h>

#include "sim/solid/turn_issues.hpp"
#include "support/solid_problem.hpp"

using namespace reye;

namespace {

/// A block on a rigid face that turns, its other end held in a plane across or along the axis.
sim::SolidProblem turned_block(const std::string& plane, double turn_rad) {
  auto block = support::solid("block", support::block(mesh::SolidKind::hex8, {2, 2, 2}, base::Vec3::Ones()), 1e5, 0.3);
  auto drive =
      support::by_node("drive", "z0", {support::fixed_motion(), support::fixed_motion(), support::fixed_motion()});
  drive.rigid = true;
  drive.about = {support::fixed_motion(), support::fixed_motion(), support::moved(turn_rad, "turn")};
  block.supports = {drive, support::symmetry("middle", plane)};
  sim::SolidProblem problem;
  problem.inputs = {block};
  problem.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 2.0}};
  problem.scene.steps = {support::step_of(1, {"turn"})};
  return problem;
}

}  // namespace

TEST(TurnIssues, FarTurnsAreRefusedWhereASupportKeepsTheDirection) {
  // A body that a further support keeps from turning along with its directions is not turned by more than 0.05 rad.
  const auto issues_of = [](const sim::SolidProblem& problem) {
    return sim::turn_issues(problem.scene, problem.inputs);
  };
  const auto issues = issues_of(turned_block("x1", 0.03));
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].key, "support.drive.rotation_z");
  EXPECT_EQ(issues[0].rule,
            "turns by 0.06 rad; beside support \"middle\", whose directions do not turn with the body, rotations are "
            "linear, and 0.05 rad, which stretches by 0.1 %, is the most");
  EXPECT_TRUE(issues_of(turned_block("x1", 0.02)).empty());
  EXPECT_TRUE(issues_of(turned_block("z1", 3.0)).empty());
}

TEST(TurnIssues, TurnsBeyondAnyRunAreRefused) {
  // A turn that would take more than a million increments, as of degrees times seconds, is refused and not begun.
  auto problem = turned_block("z1", 1e9);
  problem.scene.steps[0].name = "spin";
  problem.scene.supports = problem.inputs[0].supports;
  const auto issues = sim::turn_issues(problem.scene, problem.inputs);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].key, "step[0]");
  EXPECT_EQ(issues[0].rule,
            "its rotations take 6.667e+09 increments of at most 0.3 rad; at most 1e6 are played. Angles are in "
            "rad");
}
