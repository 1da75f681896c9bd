#include <cmath>

#include "contact_scene.hpp"
#include "sim/problem/records.hpp"

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

/// Root of the mean square error of Hertz's pressure at middle nodes with |x| < 0.7 a, over two positions of the mesh
/// with facets of the given length.
double middle_error(double size, const std::string& dual) {
  double sum = 0.0;
  int count = 0;
  for (const double shift : {0.0, 0.4}) {
    Replacements words = second_order("steel");
    words.insert(words.end(), {{"centre_mm = [0.0, 0.0]", "centre_mm = [" + std::to_string(shift * size) + ", 0.0]"},
                               {"size_mm = 0.010", "size_mm = " + std::to_string(size)},
                               {"increments = 5", "increments = 1"},
                               {"secondary = \"face\"", "secondary = \"face\"\ndual = \"" + dual + '"'}});
    const auto run = played(scene_text("hertz_halfplane", words));
    const auto p = profile(run.surface(Side::secondary), run.surface(Side::secondary).pressure_MPa);
    for (std::size_t i = 1; i < p.x.size(); i += 2) {
      if (std::abs(p.x[i]) > 0.7 * LowHertz::a) continue;
      sum += std::pow(p.value[i] / LowHertz::p0 - hertz(p.x[i], LowHertz::a, 1.0), 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

}  // namespace

/// The tables' pressure at middle nodes converges to Hertz's, faster than with h, with multipliers of either kind.
TEST(SecondOrderTables, PressureAtMiddleNodes) {
  for (const std::string dual : {"quadratic", "linear"}) {
    const double coarse = middle_error(0.08, dual), fine = middle_error(0.02, dual);
    EXPECT_GT(0.5 * std::log2(coarse / fine), 1.5) << dual << ": " << coarse << ' ' << fine;
  }
}

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

/// A scar on a block under a ring has the same depth and area with elements of either order, and its ledger closes.
TEST(SecondOrderWear, BlockOnRing) {
  const Played linear = block_on_ring(false), quadratic = block_on_ring(true);
  ASSERT_EQ(mesh::order(quadratic.state.shapes.at(0)->mesh.kind), 2);
  for (const Played* run : {&linear, &quadratic}) EXPECT_LT(run->contact().ledger_relative_error.value(), 1e-9);
  const auto &one = linear.contact().secondary, &two = quadratic.contact().secondary;
  EXPECT_NEAR(two.max_depth_mm / one.max_depth_mm, 1.0, 0.01);
  EXPECT_NEAR(two.worn_area / one.worn_area, 1.0, 0.01);
  // The tables' depth is how far the outline has moved, at middle nodes, too.
  const auto& table = quadratic.surface(Side::secondary);
  int nodes = 0;
  for (std::size_t i = 0; i < table.node.size(); ++i) {
    if (std::abs(table.x_mm[i]) > 0.2) continue;
    EXPECT_NEAR(table.wear_depth_mm[i] / -table.y_mm[i], 1.0, 5e-4) << table.x_mm[i];
    ++nodes;
  }
  EXPECT_GT(nodes, 10);
}

}  // namespace reye::verification
