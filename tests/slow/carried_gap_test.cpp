#include "verification/watched_remeshes.hpp"

using namespace reye;
using namespace reye::verification;

struct WornScene {
  const char* name;
  double pressure_jump;  ///< of its largest, relative to the mean square
};

class CarriedGapScenes : public testing::TestWithParam<WornScene> {};

// Whatever is worn to a conforming contact must keep its pressure over every remesh within 2 % (5 % in the pin, whose contact
// ends at a corner that moves along its boundary), its largest depth within 0.5 % and its book of volumes to 1e-9.
TEST_P(CarriedGapScenes, KeepPressureAndDepth) {
  const auto w = watched(scene_text(GetParam().name));
  EXPECT_GE(w.remeshes.size(), 2U);
  for (const auto& r : w.remeshes)
    EXPECT_LT(r.pressure_jump, GetParam().pressure_jump) << r.body << " at cycle " << r.cycle << ": " << r.reason;
  EXPECT_LT(w.depth_step, 0.005);
  EXPECT_LT(w.run.contact().ledger_relative_error.value(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Geo, CarriedGapScenes,
                         testing::Values(WornScene{"pin_worn_flat", 0.05}, WornScene{"block_on_ring", 0.02},
                                         WornScene{"fretting_deep", 0.02}, WornScene{"pin_in_hole", 0.02},
                                         WornScene{"ball_worn_flat", 0.02}),
                         [](const auto& info) { return std::string(info.param.name); });
