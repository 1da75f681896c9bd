#include <cmath>

#include "verification/wear_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

/// The hinge for a few cycles.
std::string hinge(const Replacements& changes) {
  Replacements all{{"cycles     = 1e6", "cycles     = 1e4"}, {"{ tolerance = 0.01 }", "5000"}, {"per_decade = 5", "every_blocks = 1"}};
  all.insert(all.end(), changes.begin(), changes.end());
  return scene_text("hinge", all);
}

const Replacements rigid{{"at       = [0, -7]\nmaterial = \"steel\"", "at    = [0, -7]\nrigid = true"}};

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
