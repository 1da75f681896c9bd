#include <cmath>

#include "wear_scene.hpp"

/// Wear of bodies of second order: quadratic edges, multipliers and depths in Bernstein functions.
namespace reye::verification {

namespace {

using sim::Side;

Replacements second_order(const std::string& material) {
  const std::string line = "material = \"" + material + "\"\n";
  return {{line + "mesh ", line + "order    = 2\nmesh "}};
}

/// The first 400 m of the block on the ring, with elements three times as long as the scene's.
Played block_on_ring(bool quadratic) {
  Replacements words{{"far_size_mm = 1.0", "far_size_mm = 2.0"},
                     {"far_size_mm = 0.6", "far_size_mm = 1.0"},
                     {"size_mm = 0.020", "size_mm = 0.060"},
                     {"cycles = 3400", "cycles = 200"}};
  if (quadratic) words.push_back(second_order("steel").front());
  return played(scene_text("block_on_ring", words));
}

}  // namespace

/// Blocks of equal width whose meshes of second order do not match wear by coefficient times energy, everywhere.
TEST(SecondOrderWear, SlidingBlock) {
  const Played run = played(scene_text("sliding_block", second_order("cork")));
  ASSERT_EQ(mesh::order(run.state.shapes.at(0)->mesh.kind), 2);
  EXPECT_NEAR(run.contact().dissipated_energy / 30000.0, 1.0, 1e-9);
  EXPECT_NEAR(run.contact().secondary.worn_area / 3.0e-3, 1.0, 1e-9);
  EXPECT_NEAR(run.contact().primary.worn_area / 1.5e-3, 1.0, 1e-9);
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-9);
  EXPECT_LT(worst(run.surface(Side::secondary).wear_depth_mm, 3e-4), 1e-9);
  EXPECT_LT(worst(run.surface(Side::primary).wear_depth_mm, 1.5e-4), 1e-9);
}

/// A scar on a block under a ring has the same depth and area with elements of either order, and its book is kept.
TEST(SecondOrderWear, BlockOnRing) {
  const Played linear = block_on_ring(false), quadratic = block_on_ring(true);
  ASSERT_EQ(mesh::order(quadratic.state.shapes.at(0)->mesh.kind), 2);
  for (const Played* run : {&linear, &quadratic}) EXPECT_LT(run->contact().ledger_relative_error.value(), 1e-9);
  const auto &one = linear.contact().secondary, &two = quadratic.contact().secondary;
  EXPECT_NEAR(two.max_depth_mm / one.max_depth_mm, 1.0, 0.01);
  EXPECT_NEAR(two.worn_area / one.worn_area, 1.0, 0.01);
}

}  // namespace reye::verification
