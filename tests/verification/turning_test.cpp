#include <numbers>

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

// A shaft that spins by whole turns must wear coefficient x load x way, however few increments a turn is asked in.
TEST(Turning, WholeTurnsWearTheWay) {
  for (const int increments : {4, 24}) {
    const auto spun =
        played(scene_text("spinning_shaft", {{"cycles     = 1000", "cycles     = 2"},
                                             {"increments = 24", "increments = " + std::to_string(increments)}}));
    const double way = 2.0 * 2.0 * std::numbers::pi * 10.0, load = 40.0, coefficient = 1e-9;
    EXPECT_NEAR(spun.contact().secondary.worn_area / (coefficient * load * way), 1.0, 1e-3) << increments;
  }
}

}  // namespace
