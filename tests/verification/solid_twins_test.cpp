#include "verification/solid_twins.hpp"

using namespace reye;
using verification::DrawnOut;
using verification::scene_text;

namespace {

/// The twins differ by at most so much in depth and volume, and at any node where the plane keeps its mesh.
void expect_twins(const verification::WornTwins& twins, double least_depth_mm, double depth, double rest) {
  EXPECT_GT(twins.plane_depth_mm, least_depth_mm);
  EXPECT_NEAR(twins.depth, 0.0, depth);
  EXPECT_NEAR(twins.volume, 0.0, rest);
  EXPECT_LE(twins.profile, rest);
}

}  // namespace

TEST(SolidTwins, FrettingOfACylinderIsThePlanesOwn) {
  // 18 000 cycles of geo/fretting_mccoll as a slice that cannot move across itself wear as the plane does: deepest,
  // volume and every node within 0.1 %.
  const auto text =
      scene_text("fretting_mccoll",
                 {{"size_mm = 0.010", "size_mm = 0.040"},
                  {"increments = 40\nwear = false", "increments = 16\nwear = false"},
                  {"increments = 40\ncycles = 18000\njump = 100", "increments = 16\ncycles = 18000\njump = 600"},
                  {"every_cycles = 1000", "every_cycles = 18000"}});
  expect_twins(verification::worn_twins(text, DrawnOut::slice(0.1)), 0.002, 1e-3, 1e-3);
}

TEST(SolidTwins, ABlockWornByARingIsThePlanesOwn) {
  // 800 m of geo/block_on_ring as a slice: deepest, area and every node within 0.05 %.
  const auto text =
      scene_text("block_on_ring", {{"size_mm = 0.020", "size_mm = 0.060"}, {"cycles = 3400", "cycles = 600"}});
  expect_twins(verification::worn_twins(text, DrawnOut::slice(0.2)), 0.015, 5e-4, 5e-4);
}

TEST(SolidTwins, AWedgeOfARingIsAxisymmetric) {
  // 30 degrees of geo/ring_on_ring_axisymmetric, worn deep enough that its round face becomes flat: depth within 0.5 %,
  // volume within 0.05 %, for the slope of facets that the contact sees as fitted. Depth adds up what each shape step
  // moves: nodes of a curved face draw nearer as it wears.
  const auto text = scene_text(
      "ring_on_ring_axisymmetric",
      {{"imposed_sliding_mm = 628318.5307179587", "imposed_turn_rad = 6283.185307179587"}, {"jump = 3", "jump = 30"}});
  expect_twins(verification::worn_twins(text, DrawnOut::wedge(std::numbers::pi / 6.0, 6)), 2.0, 5e-3, 5e-4);
}
