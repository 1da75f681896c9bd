#include "verification/watched_remeshes.hpp"

using namespace reye;
using namespace reye::verification;

struct WornScene {
  const char* name;
};

void PrintTo(const WornScene& scene, std::ostream* out) { *out << scene.name; }

class CarriedGapScenes : public testing::TestWithParam<WornScene> {};

// Whatever is worn to a conforming contact must keep its pressure over every remesh within 2 % (at each node within 0.9
// of its width 3 %), its largest depth within 0.5 % and the ledger must close to 1e-9.
TEST_P(CarriedGapScenes, KeepPressureAndDepth) {
  const auto w = watched(scene_text(GetParam().name));
  EXPECT_GE(w.remeshes.size(), 2U);
  for (const auto& r : w.remeshes) {
    EXPECT_LT(r.pressure_jump, 0.02) << r.body << " at cycle " << r.cycle << ": " << r.reason;
    EXPECT_LT(r.peak_jump, 0.03) << r.body << " at cycle " << r.cycle << ": " << r.reason;
  }
  EXPECT_LT(w.depth_step, 0.005);
  EXPECT_LT(w.run.contact().ledger_relative_error.value(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Geo, CarriedGapScenes,
                         testing::Values(WornScene{"pin_worn_flat"}, WornScene{"block_on_ring"},
                                         WornScene{"fretting_deep"}, WornScene{"pin_in_hole"},
                                         WornScene{"ball_worn_flat"}),
                         [](const auto& scene) { return std::string(scene.param.name); });
