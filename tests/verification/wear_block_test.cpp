#include <algorithm>
#include <cmath>

#include "sim/march/block.hpp"
#include "sim/measure/measure.hpp"
#include "sim/reshape/shape.hpp"
#include "wear_scene.hpp"

/// References B5: a block under 10 MPa, mu = 0.3, slides 1000 mm: 3 J/mm^2, depth 3e-4 mm at alpha = 1e-4 mm^3/J.
namespace reye::verification {

namespace {

using sim::Side;

const std::string block_sides = "secondary = \"slider_bottom\"\nprimary   = [\"base_top\"]";
const std::string swapped_sides = "secondary = \"base_top\"\nprimary   = [\"slider_bottom\"]";
const std::string both_coefficients = "secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4";

/// The counter body 5 mm wider on either side, under the same pressure and shear beside the slider.
Replacements wider(const std::string& E, const std::string& lean) {
  const auto beside = [](const std::string& name, const std::string& interval) {
    return "[load." + name + "]\nedge = \"base_top\"\ninterval_mm = " + interval +
           "\ntraction_MPa = [3.0, -10.0]\nhistory = \"press\"\n\n";
  };
  return {{"blocks.geo", "wider_base.geo"},
          {"E_MPa = 200e6", "E_MPa = " + E},
          {"motion_mm = 3.0e-7", "motion_mm = " + lean},
          {"[history]\n", beside("left", "[0.0, 5.0]") + beside("right", "[15.0, 20.0]") + "[history]\n"}};
}

void expect_block_book(const Played& run, double secondary, double primary) {
  EXPECT_NEAR(run.contact().dissipated_energy / 30000.0, 1.0, 1e-10);
  EXPECT_NEAR(run.contact().secondary.worn_area, secondary * 10.0, 1e-10 * 3e-3);
  EXPECT_NEAR(run.contact().primary.worn_area, primary * 10.0, 1e-10 * 3e-3);
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-12);
}

void expect_both_worn(const Played& run) {
  expect_block_book(run, 3e-4, 1.5e-4);
  EXPECT_LT(worst(run.surface(Side::secondary).wear_depth_mm, 3e-4), 1e-10);
  EXPECT_LT(worst(run.surface(Side::primary).wear_depth_mm, 1.5e-4), 1e-10);
}

/// Mean of |depth - exact| over the worn length, in parts of the exact depth; exact: 3e-4 mm on 0 < x < 10.
double end_effect(const sim::SurfaceRecord& s) {
  double sum = 0.0;
  constexpr int parts = 400;
  for (std::size_t i = 1; i < s.x_mm.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      const double t = (k + 0.5) / parts, x = s.x_mm[i - 1] + t * (s.x_mm[i] - s.x_mm[i - 1]);
      const double w = s.wear_depth_mm[i - 1] + t * (s.wear_depth_mm[i] - s.wear_depth_mm[i - 1]);
      sum += std::abs(w - (x > 0.0 && x < 10.0 ? 3e-4 : 0.0)) * (s.x_mm[i] - s.x_mm[i - 1]) / parts;
    }
  return sum / 3e-3;
}

/// The wider body wears, softly held so that the shallow ends of its scar are pressed flat.
double end_effect_of_wider(const Replacements& roles, Side side, const std::string& size) {
  const Replacements mesh{{"far_size_mm = 0.5", "far_size_mm = " + size},
                          {"far_size_mm = 0.7", "far_size_mm = " + size}};
  const Played run = played(scene_text("sliding_block", wider("2e3", "0.03") + roles + mesh));
  const auto& worn = side == Side::secondary ? run.contact().secondary : run.contact().primary;
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-10);
  EXPECT_NEAR(worn.worn_area / 3e-3, 1.0, 1e-6);  // the slopes at the ends turn the pressure a little
  return end_effect(run.surface(side));
}

}  // namespace

/// Depth and volume are exact on both sides of blocks of equal width whose meshes do not match.
TEST(WearBlock, BothWearNonMatching) { expect_both_worn(played(scene_text("sliding_block"))); }

TEST(WearBlock, BothWearMatching) {
  expect_both_worn(played(scene_text("sliding_block", {{"far_size_mm = 0.7", "far_size_mm = 0.5"}})));
}

TEST(WearBlock, BothWearRolesExchanged) {
  expect_both_worn(played(scene_text("sliding_block", {{block_sides, swapped_sides}})));
}

TEST(WearBlock, OnlyOneWears) {
  const Played run = played(
      scene_text("sliding_block", {{both_coefficients, "secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.0"}}));
  expect_block_book(run, 3e-4, 0.0);
  EXPECT_LT(worst(run.surface(Side::secondary).wear_depth_mm, 3e-4), 1e-10);
}

/// Sliding the other way wears the same.
TEST(WearBlock, SlidingOfEitherSign) {
  const Played run = played(scene_text("sliding_block", {{"imposed_sliding_mm = 100.0", "imposed_sliding_mm = -100.0"},
                                                         {"[0.0, 3.0]", "[0.0, 3.00]"},
                                                         {"[0.0, -3.0]", "[0.0, 3.0]"},
                                                         {"[0.0, 3.00]", "[0.0, -3.0]"},
                                                         {"motion_mm = 3.0e-7", "motion_mm = -3.0e-7"}}));
  expect_both_worn(run);
  EXPECT_NEAR(run.contact().tangential_force, 30.0, 3e-9);  // to which the solver balances: 1e-10 of it
}

/// In full slip Archard's law with k = alpha mu is the energy law.
TEST(WearBlock, ArchardAgreesWithEnergy) {
  const Replacements archard{{"law = \"energy\"", "law = \"archard\""},
                             {both_coefficients, "secondary_per_MPa = 0.3e-7, primary_per_MPa = 0.15e-7"}};
  expect_both_worn(played(scene_text("sliding_block", archard)));
}

/// A wider counter body that does not wear leaves the depth of the narrower exact, in either role.
TEST(WearBlock, NarrowerWearsAsSecondary) {
  const Played run = played(
      scene_text("sliding_block", wider("200e6", "3.0e-7") + Replacements{{", primary_mm3_per_J = 0.5e-4", ""}}));
  expect_block_book(run, 3e-4, 0.0);
  EXPECT_LT(worst(run.surface(Side::secondary).wear_depth_mm, 3e-4), 1e-10);
}

TEST(WearBlock, NarrowerWearsAsPrimary) {
  const Played run = played(scene_text(
      "sliding_block", wider("200e6", "3.0e-7") + Replacements{{block_sides, swapped_sides},
                                                               {both_coefficients, "primary_mm3_per_J = 1.0e-4"}}));
  expect_block_book(run, 0.0, 3e-4);
  EXPECT_LT(worst(run.surface(Side::primary).wear_depth_mm, 3e-4), 1e-10);
}

/// Where the wider body wears, what is wrong at the ends of its scar falls with the element size.
TEST(WearBlock, WiderWearsAsSecondary) {
  const Replacements roles{{block_sides, swapped_sides}, {both_coefficients, "secondary_mm3_per_J = 1.0e-4"}};
  const double coarse = end_effect_of_wider(roles, Side::secondary, "0.6"),
               fine = end_effect_of_wider(roles, Side::secondary, "0.15");
  EXPECT_LT(coarse, 0.08);
  EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 0.8);
}

TEST(WearBlock, WiderWearsAsPrimary) {
  const Replacements roles{{both_coefficients, "primary_mm3_per_J = 1.0e-4"}};
  const double coarse = end_effect_of_wider(roles, Side::primary, "0.6"),
               fine = end_effect_of_wider(roles, Side::primary, "0.15");
  EXPECT_LT(coarse, 0.08);
  EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 0.8);
}

/// A node that its neighbours' wear opens lets go: would it pull, more work than mu P s would be booked (seen: 1.5 %).
TEST(WearBlock, OpenedByNeighbours) {
  const Replacements mesh{{"far_size_mm = 0.5", "far_size_mm = 0.125"}, {"far_size_mm = 0.7", "far_size_mm = 0.175"}};
  const Played run =
      played(scene_text("sliding_block", wider("200e3", "3.0e-4") + mesh +
                                             Replacements{{both_coefficients, "primary_mm3_per_J = 1.0e-4"}}));
  EXPECT_NEAR(run.contact().dissipated_energy / 30000.0, 1.0, 1e-6);
  for (double p : run.surface(Side::secondary).pressure_MPa) EXPECT_GE(p, 0.0);
}

/// Wear that moves from the gap into the shape of flat blocks under force leaves the multipliers alone (references
/// B11).
TEST(WearBlock, ShapeStepLeavesPressureAlone) {
  const Replacements ten_times_softer{{"E_MPa = 200e6", "E_MPa = 20e6"}, {"motion_mm = 3.0e-7", "motion_mm = 3.0e-6"}};
  const auto problem = prepared(scene_text("sliding_block", ten_times_softer));
  auto state = sim::initial_state(problem);
  sim::Cache cache;
  sim::begin_state(problem, state, cache);
  for (const auto& step : problem.scene.steps) {
    auto outcome = sim::play_increments(problem, state, cache, {&step, 1.0, step.cycles > 0.0}, {});
    ASSERT_EQ(outcome.failure, "");
    state = std::move(outcome.state);
  }
  const auto moved = sim::evolve_shape(problem, state, cache, {&problem.scene.steps.back(), 1.0, true}, {});
  ASSERT_EQ(moved.failure, "");
  const auto &before = state.solution.contacts[0], &after = moved.state.solution.contacts[0];
  EXPECT_GT(*std::max_element(before.pending_secondary.begin(), before.pending_secondary.end()), 0.0);
  for (std::size_t j = 0; j < before.lambda.size(); ++j) {
    EXPECT_LT((after.lambda[j] - before.lambda[j]).norm(), 1e-10 * before.lambda[j].norm());
    EXPECT_EQ(after.pending_secondary[j], 0.0);
  }
}

}  // namespace reye::verification
