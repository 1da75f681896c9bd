#include <cmath>
#include <numeric>

#include "sim/problem/records.hpp"
#include "support/scene_words.hpp"
#include "wear_scene.hpp"

/// A block pressed on its top and dragged to and fro by its side, over a base: the node at the side slides as all
/// others.
namespace reye::verification {

namespace {

const std::string dragged_geo = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {1, 0, 0, 2, 1};
Rectangle(2) = {0, -1, 0, 4, 1};
Physical Surface("slider") = {1};
Physical Surface("base") = {2};
Physical Curve("slider_bottom") = {1};
Physical Curve("slider_top") = {3};
Physical Curve("slider_left") = {4};
Physical Curve("base_bottom") = {5};
Physical Curve("base_top") = {7};
)";

const std::string dragged_scene =
    "geometry = [\"reye_dragged.geo\"]\n" +
    support::steel_bodies({{"slider", "far_size_mm = 0.25"}, {"base", "far_size_mm = 0.25"}}) + R"([contact.pad]
secondary = "slider_bottom"
primary   = ["base_top"]
friction  = 0.3
wear      = { law = "energy", secondary_mm3_per_J = 1.0e-6 }
[support.side]
edge = "slider_left"
x    = { motion_mm = 0.1, history = "stroke" }
[support.floor]
edge = "base_bottom"
x    = "fixed"
y    = "fixed"
[load.weight]
edge         = "slider_top"
pressure_MPa = 10.0
history      = "press"
[history]
press  = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]
[[step]]
name = "press"
play = ["press"]
wear = false
[[step]]
name = "rub"
play = ["stroke"]
increments = 8
cycles = 1
)";

constexpr double mu_N = 0.3 * 20.0;            ///< N/mm
constexpr double path_of_a_cycle = 4.0 * 0.1;  ///< mm in a cycle

Played rubbed(const Replacements& changes = {}) {
  std::ofstream(support::temporary_folder() + "reye_dragged.geo") << dragged_geo;
  return played(replaced(dragged_scene, changes));
}

double along(const sim::IncrementRecord& r) { return r.support_forces[0].x(); }

}  // namespace

/// Of a block so stiff that its foot stays flat the drive is mu N to the last digit, either way, and each step of it
/// dissipates mu N times its length.
TEST(DraggedBlock, FeelsAllOfFriction) {
  const Played run = rubbed(
      {{"E_MPa = 200e3", "E_MPa = 200e9"}, {"wear      = { law = \"energy\", secondary_mm3_per_J = 1.0e-6 }", ""}});
  ASSERT_EQ(run.records.size(), 9U);
  for (std::size_t i : {2U, 4U, 5U, 6U, 8U}) {
    const double way = i > 2 && i < 7 ? -1.0 : 1.0;
    EXPECT_NEAR(along(run.records[i]) / mu_N, way, 1e-9) << i;
  }
  for (std::size_t i : {2U, 5U, 6U, 8U})
    EXPECT_NEAR((run.records[i].energy_mJ - run.records[i - 1].energy_mJ) / (mu_N * path_of_a_cycle / 8.0), 1.0, 1e-9)
        << i;
}

/// All of the way but the springs of the block is slip, and wears.
TEST(DraggedBlock, WearsWithAllOfItsWork) {
  const Played run = rubbed();
  EXPECT_NEAR(run.contact().dissipated_energy / (mu_N * path_of_a_cycle), 1.0, 2e-3);
  EXPECT_NEAR(run.contact().secondary.worn_area / (1e-9 * mu_N * path_of_a_cycle), 1.0, 2e-3);
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-12);
}

}  // namespace reye::verification
