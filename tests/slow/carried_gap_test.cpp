#include "verification/watched_remeshes.hpp"

using namespace reye;
using namespace reye::verification;

/// Every remesh of a scene keeps the pressure within 2 % of its mean square, depth within 0.5 %, the ledger to 1e-9.
class CarriedGapScenes : public testing::TestWithParam<const char*> {};

// Whatever is worn to a conforming contact must keep its pressure, depth and volume over every remesh.
TEST_P(CarriedGapScenes, KeepPressureAndDepth) {
  const auto w = watched(scene_text(GetParam()));
  EXPECT_GE(w.remeshes.size(), 2U);
  for (const auto& r : w.remeshes) EXPECT_LT(r.pressure_jump, 0.02) << r.body << " at cycle " << r.cycle << ": " << r.reason;
  EXPECT_LT(w.depth_step, 0.005);
  EXPECT_LT(w.run.contact().ledger_relative_error.value(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Geo, CarriedGapScenes,
                         testing::Values("pin_worn_flat", "block_on_ring", "fretting_deep", "pin_in_hole", "ball_worn_flat"));
