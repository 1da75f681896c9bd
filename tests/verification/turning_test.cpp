#include "verification/hinge.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

// A shaft that swings by half a radian must wear its bush as a rigid one does: it turns, and does not swell.
TEST(Turning, ShaftWearsAsARigidOne) {
  const auto swung = played(hinge({})), stiff = played(hinge(rigid));
  EXPECT_NEAR(swung.contact().secondary.max_depth_mm, stiff.contact().secondary.max_depth_mm,
              0.05 * stiff.contact().secondary.max_depth_mm);  // 0.4 um deep: the corners of either shaft's own facets
  EXPECT_NEAR(swung.contact().secondary.worn_area, stiff.contact().secondary.worn_area,
              0.01 * stiff.contact().secondary.worn_area);
  for (const auto& warning : swung.summary.warnings) EXPECT_NE(warning.kind, "strain") << warning.text;
}

}  // namespace
