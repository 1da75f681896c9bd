#include "support/solid_turning.hpp"

using namespace reye;
using namespace reye::support;

TEST(SolidTurning, WearWhileTheSceneTurnsIsWearAtRest) {
  // Blocks that wear while both turn as one lose, node by node, the volumes of the same wear without the turn, in as
  // many iterations: wear follows the slip that is seen from the bodies, and so does its tangent.
  wear::Law law;
  law.kind = wear::LawKind::energy;
  law.secondary = 2e-4;
  law.primary = 1e-4;
  const auto straight = slid_blocks(false, law), turned = slid_blocks(true, law);
  expect_same_sliding(straight, turned);
  const auto &own = straight.back().state.wear[0], &other = turned.back().state.wear[0];
  const double most = *std::max_element(own.removed_secondary.begin(), own.removed_secondary.end());
  ASSERT_GT(most, 0.0);
  for (std::size_t j = 0; j < own.removed_secondary.size(); ++j)
    EXPECT_NEAR(other.removed_secondary[j], own.removed_secondary[j], 1e-9 * most) << j;
  for (std::size_t l = 0; l < own.removed_primary.size(); ++l)
    EXPECT_NEAR(other.removed_primary[l], own.removed_primary[l], 1e-9 * most) << l;
}

namespace {

constexpr double of_bush = 2e-5, of_pin = 1e-4;  ///< wear coefficients [mm^2/N]

/// A pin that wears in a bush while it turns on: by `first_turns`, and by as much again.
sim::SolidProblem worn_pin(double first_turns, int increments, bool shape) {
  PinInShell scene{.half_angle = std::numbers::pi, .cells = 60};
  scene.turn = moved(2.0 * std::numbers::pi * first_turns, "turn");
  scene.turn.parts.push_back({2.0 * std::numbers::pi * first_turns, "on"});
  auto problem = scene.problem();
  auto& wear = problem.contacts[0].options.wear;
  wear.kind = wear::LawKind::energy;
  wear.secondary = of_bush;
  wear.primary = of_pin;
  problem.scene.histories["on"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.shape = shape;
  for (const std::string play : {"turn", "on"}) {
    problem.scene.steps.push_back(step_of(increments, {play}));
    problem.scene.steps.back().wear = true;
  }
  return problem;
}

/// Least and largest depth of one side where a choice by the place on X holds.
template <class Choice>
std::array<double, 2> depths(const sim::SkinRecord& surface, Choice chosen) {
  std::array<double, 2> range{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i < surface.x_mm.size(); ++i) {
    if (!chosen(surface.x_mm[i])) continue;
    range[0] = std::min(range[0], surface.wear_depth_mm[i]);
    range[1] = std::max(range[1], surface.wear_depth_mm[i]);
  }
  return range;
}

/// V = alpha E of both sides, E the work since the pin was pressed, and nothing missing in the ledger.
void expect_volumes_by_work(const PlayedSolids& played) {
  const auto& contact = played.summary.contacts[0];
  const double work = played.rows.back().contacts[0].energy_mJ - played.rows[2].contacts[0].energy_mJ;
  ASSERT_GT(work, 0.0);
  EXPECT_NEAR(contact.secondary.worn_volume_mm3, of_bush * work, 1e-9 * of_bush * work);
  EXPECT_NEAR(contact.primary.worn_volume_mm3, of_pin * work, 1e-9 * of_pin * work);
  EXPECT_LE(*contact.ledger_relative_error, 1e-9);
}

}  // namespace

TEST(SolidTurningWear, APinThatTurnsWearsAllRoundItsBushWhereItPresses) {
  // A pin that turns twice in a bush wears alike all round, for its scar stays on it; the bush wears below alone. Both
  // lose what the law says of the work, which is torque times angle within the square of a facet's angle.
  constexpr int per_turn = 24;
  const auto played = play(worn_pin(1.0, per_turn, false));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  ASSERT_EQ(played.rows.size(), 3u + 2 * per_turn);
  expect_volumes_by_work(played);
  const auto& surfaces = played.frames.back().surfaces;
  const auto pin = depths(surfaces[1], [](const Vec3&) { return true; });
  EXPECT_GT(pin[0], 0.9 * pin[1]);
  const auto above = depths(surfaces[0], [](const Vec3& X) { return X.y() > 0.0; });
  const auto below = depths(surfaces[0], [](const Vec3& X) { return X.y() < -0.99 * bush_R; });
  EXPECT_EQ(above[1], 0.0);
  EXPECT_GT(below[0], 0.2 * pin[1]);
  const double angle = 2.0 * std::numbers::pi / per_turn, facet = 2.0 * std::numbers::pi / 60;
  for (std::size_t k = 4; k < played.rows.size(); ++k) {
    const double work = played.rows[k].contacts[0].energy_mJ - played.rows[k - 1].contacts[0].energy_mJ;
    EXPECT_NEAR(work, played.rows[k].supports[1].moment_N_mm.z() * angle, facet * facet * work) << k;
  }
}

TEST(SolidTurningWear, AShapeStepOfATurnedPinLeavesItWhereItIs) {
  // Where the worn faces of a pin that has turned by 0.3 turns move, the pin stays turned with its scar: work and
  // depths after as much again are those of a run in which the wear waits in the gap.
  const auto moved_faces = play(worn_pin(0.3, 8, true)), gap = play(worn_pin(0.3, 8, false));
  for (const auto* played : {&moved_faces, &gap}) {
    ASSERT_EQ(played->summary.status, sim::RunStatus::done) << played->summary.reason;
    expect_volumes_by_work(*played);
  }
  const auto &own = moved_faces.frames.back().surfaces[1], &other = gap.frames.back().surfaces[1];
  const double most = depths(other, [](const Vec3&) { return true; })[1];
  ASSERT_EQ(own.wear_depth_mm.size(), other.wear_depth_mm.size());
  for (std::size_t i = 0; i < own.wear_depth_mm.size(); ++i)
    EXPECT_NEAR(own.wear_depth_mm[i], other.wear_depth_mm[i], 0.02 * most) << i;
  const auto work = [](const PlayedSolids& played) { return played.rows.back().contacts[0].energy_mJ; };
  EXPECT_NEAR(work(moved_faces), work(gap), 5e-3 * work(gap));
}
