#include "verification/contact_scene.hpp"

using namespace reye;
using namespace reye::verification;

// Two pressed blocks (references C5): small strain must lie below the published multipliers by the factor between
// strain and log strain, -ln(1 - e) / e = 1.044 at e = 1/12, at mid-height within 0.2 %, less towards the free ends.
TEST(ContactBlocks, DualMultipliers) {
  const auto run = played(scene_text("two_blocks_dual"));
  const auto& s = run.surface(sim::Side::secondary);
  std::map<double, double> pressure;
  for (std::size_t i = 0; i < s.node.size(); ++i) pressure[s.y_mm[i]] = s.pressure_MPa[i];
  std::vector<double> p;
  for (const auto& [y, value] : pressure) p.push_back(value);
  ASSERT_EQ(p.size(), 7U);
  const double factor = -std::log(1.0 - 1.0 / 12.0) * 12.0;
  EXPECT_NEAR(p[3] * factor, 112799.85, 0.002 * 112799.85);
  const double published[4] = {86628.75, 101873.31, 112298.40, 112799.85};
  for (int k = 0; k < 4; ++k) {
    EXPECT_LT(p[k], published[k]);
    EXPECT_GT(p[k], 0.95 * published[k]);
    EXPECT_NEAR(p[k] / p[3], published[k] / published[3], 0.025);
    EXPECT_NEAR(p[k], p[6 - k], 1e-9 * p[3]);
  }
}
