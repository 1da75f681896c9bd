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
