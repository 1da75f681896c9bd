#include <cmath>

#include "support/solid_worn.hpp"
#include "wear_scene.hpp"

using namespace reye;
using verification::played;
using verification::scene_text;

namespace {

/// A blade root that pulses of a force press into the slot of its disc along inclined flanks, coarse; blocks of cycles
/// as asked.
verification::Played blade(const std::string& jump) {
  return played(scene_text("like/dovetail", {{"size_mm = 0.08", "size_mm = 0.2"},
                                             {"far_size_mm = 0.8", "far_size_mm = 1.6"},
                                             {"far_size_mm = 1.0", "far_size_mm = 2.0"},
                                             {"jump = { tolerance = 0.01 }", "jump = " + jump}}));
}

/// A cylinder that frets by strokes little longer than its elastic reversal, coarse; blocks of cycles as asked.
verification::Played short_strokes(const std::string& jump) {
  return played(scene_text("like/fretting", {{"motion_mm = 0.02,", "motion_mm = 0.004,"},
                                             {"cycles = 20000 ", "cycles = 40000 "},
                                             {"jump = { tolerance = 0.01 }", "jump = " + jump}}));
}

/// Two blocks of hexahedra that meet on a plane inclined by 35 degrees; the upper one is pressed down by a force that
/// pulses and moves along z alone.
sim::SolidProblem wedge(double tolerance, double jump) {
  using support::Vec3;
  const double slope = 0.7;
  auto lower = support::solid("lower",
                              support::block(mesh::SolidKind::hex8, {6, 1, 3}, Vec3::Ones(),
                                             [&](const Vec3& t) {
                                               const double x = 4.0 * t.x();
                                               return Vec3(x, t.y(), -2.0 + t.z() * (2.0 + slope * x));
                                             }),
                              1e5, 0.3);
  lower.supports = {support::by_node("ground", "z0", support::held())};
  auto upper = support::solid("upper",
                              support::block(mesh::SolidKind::hex8, {4, 1, 3}, Vec3::Ones(),
                                             [&](const Vec3& t) {
                                               const double x = 1.0 + 2.0 * t.x();
                                               return Vec3(x, t.y(), slope * x + t.z() * (5.0 - slope * x));
                                             }),
                              1e5, 0.3);
  auto top = support::pressed_rigidly("z1", 40.0);
  top.along[2].parts.push_back({-160.0, "pulse"});
  upper.supports = {top};
  auto problem = support::problem_of({upper, lower}, {0, "z0"}, {1, "z1"}, 0.2, 0.2);
  problem.contacts[0].options.wear = support::archard(2e-8);
  problem.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.histories["pulse"] = {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}};
  problem.scene.steps = {support::step_of(2, {"press"}), support::step_of(8, {"pulse"}, 2e5)};
  auto& step = problem.scene.steps.back();
  step.wear = true;
  step.jump = jump;
  step.jump_tolerance = tolerance;
  problem.scene.frames.paraview = false;
  return problem;
}

}  // namespace

// Worn flanks let the blade settle outwards, once in a life and not once in every cycle that a block stands for: what
// long blocks under a tolerance wear must be what short ones of one size do. (The slip of settling, counted in all
// cycles of a block, made it a seventh too much.)
TEST(Settling, IsNoSlipOfTheCyclesThatABlockStandsFor) {
  const auto controlled = blade("{ tolerance = 0.01 }"), fine = blade("2500");
  const auto volume = [](const verification::Played& run) { return run.contact().secondary.worn_area; };
  EXPECT_LT(controlled.summary.counts.cycles_solved, 50);
  EXPECT_NEAR(volume(controlled) / volume(fine), 1.0, 0.02);
  EXPECT_LT(controlled.contact().ledger_relative_error.value(), 1e-12);
}

// Nodes that begin to touch while bodies settle into wear ahead must slide with the others: a cycle of a long block
// under a tolerance then dissipates what one of short blocks does. (With no shear there, the first increment had to
// stretch the bodies until they slid: 0.28 % less.)
TEST(Settling, NodesThatBeginToTouchSlideWithTheOthers) {
  const auto controlled = short_strokes("{ tolerance = 0.01 }"), fine = short_strokes("400");
  const auto energy = [](const verification::Played& run) { return run.contact().dissipated_energy; };
  EXPECT_LT(controlled.summary.counts.cycles_solved, 50);
  EXPECT_NEAR(energy(controlled) / energy(fine), 1.0, 5e-4);
}

// Solids that pulses of a force press along an inclined face must settle into its wear once as well: what long blocks
// under a tolerance wear is what short ones of one size do.
TEST(Settling, IsNoSlipOfTheCyclesThatABlockOfSolidsStandsFor) {
  const auto controlled = support::play(wedge(0.01, 200.0)), fine = support::play(wedge(0.0, 2000.0));
  const auto volume = [](const support::PlayedSolids& run) {
    return run.summary.contacts[0].secondary.worn_volume_mm3;
  };
  EXPECT_LT(controlled.summary.counts.cycles_solved, 50);
  EXPECT_NEAR(volume(controlled) / volume(fine), 1.0, 0.02);
  EXPECT_LT(controlled.summary.contacts[0].ledger_relative_error.value(), 1e-12);
}
