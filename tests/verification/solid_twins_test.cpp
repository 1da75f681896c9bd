#include <gtest/gtest.h>

#include <numbers>

#include "support/solid_twins.hpp"

using namespace reye;

TEST(SolidTwins, FrettingOfACylinderIsThePlanesOwn) {
  // 18 000 cycles of geo/fretting_mccoll as a slice that cannot move across itself wear as the plane does: deepest,
  // volume and every node within 0.1 %.
  const auto twins = support::worn_twins(
      support::plane_scene("fretting_mccoll", {{"size_mm = 0.010", "size_mm = 0.040"},
                                               {"increments = 40\nwear = false", "increments = 16\nwear = false"},
                                               {"increments = 40\ncycles = 18000\njump = 100",
                                                "increments = 16\ncycles = 18000\njump = 600"},
                                               {"every_cycles = 1000", "every_cycles = 18000"}}),
      support::DrawnOut::slice(0.1));
  EXPECT_GT(twins.plane_depth_mm, 0.002);
  EXPECT_NEAR(twins.depth, 0.0, 1e-3);
  EXPECT_NEAR(twins.volume, 0.0, 1e-3);
  EXPECT_LE(twins.profile, 1e-3);
}

TEST(SolidTwins, ABlockWornByARingIsThePlanesOwn) {
  // 800 m of geo/block_on_ring as a slice: deepest, area and every node within 0.05 %.
  const auto twins = support::worn_twins(support::plane_scene("block_on_ring", {{"size_mm = 0.020", "size_mm = 0.060"},
                                                                                {"cycles = 3400", "cycles = 600"}}),
                                         support::DrawnOut::slice(0.2));
  EXPECT_GT(twins.plane_depth_mm, 0.015);
  EXPECT_NEAR(twins.depth, 0.0, 5e-4);
  EXPECT_NEAR(twins.volume, 0.0, 5e-4);
  EXPECT_LE(twins.profile, 5e-4);
}

TEST(SolidTwins, AWedgeOfARingIsAxisymmetric) {
  // 30 degrees of geo/ring_on_ring_axisymmetric, worn deep enough that its round face becomes flat: depth within 0.5 %,
  // volume within 0.05 %, for the slope of facets that the contact sees as fitted. Depth adds up what each shape step
  // moves: nodes of a curved face draw nearer as it wears.
  const auto twins = support::worn_twins(
      support::plane_scene("ring_on_ring_axisymmetric",
                           {{"imposed_sliding_mm = 628318.5307179587", "imposed_turn_rad = 6283.185307179587"},
                            {"jump = 3", "jump = 30"}}),
      support::DrawnOut::wedge(std::numbers::pi / 6.0, 6));
  EXPECT_GT(twins.plane_depth_mm, 2.0);
  EXPECT_NEAR(twins.depth, 0.0, 5e-3);
  EXPECT_NEAR(twins.volume, 0.0, 5e-4);
}
