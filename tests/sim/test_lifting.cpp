#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "sim/study/run.hpp"
#include "support/problem.hpp"
#include "support/scene_words.hpp"

using namespace reye;

namespace {

/// A shim of 12 mm that lies loose on a block, pressed on 2 mm of its top: most of it lifts off.
std::string shim(const std::string& thickness) {
  return R"(SetFactory("OpenCASCADE");
Rectangle(1) = {-6, -6, 0, 12, 6};
Rectangle(2) = {-6, 0, 0, 12, )" +
         thickness + R"(};
Physical Surface("block") = {1};
Physical Surface("shim") = {2};
Physical Curve("block_bottom") = {1};
Physical Curve("block_top") = {3};
Physical Curve("shim_bottom") = {5};
Physical Curve("shim_top") = {7};
)";
}

const std::string shim_scene = "geometry = [\"shim.geo\"]\n" +
                               support::steel_bodies({{"block", "far_size_mm = 0.5"}, {"shim", "far_size_mm = 0.1"}}) +
                               R"([contact.bond]
secondary = "shim_bottom"
primary   = ["block_top"]
friction  = 0.3
fine_zone = { centre_mm = [0, 0], half_width_mm = 1.0, depth_mm = 0.2, size_mm = 0.05 }
[support.base]
edge = "block_bottom"
x    = "fixed"
y    = "fixed"
[load.press]
edge         = "shim_top"
pressure_MPa = 100.0
interval_mm  = [5.0, 7.0]
history      = "press"
)" + support::press_step(2);

/// A cylinder pressed on a coat of 20 um that nothing but friction holds on its substrate.
const char* const coated_geometry = R"(SetFactory("OpenCASCADE");
Disk(1) = {0, 6.02, 0, 6};
Rectangle(2) = {-7, 6.02, 0, 14, 7};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Rectangle(4) = {-6, 0, 0, 12, 0.02};
Rectangle(5) = {-6, -6, 0, 12, 6};
Physical Surface("cylinder") = {3};
Physical Surface("coat") = {4};
Physical Surface("substrate") = {5};
)";

const std::string coated_scene =
    "geometry = [\"coated.geo\"]\n" +
    support::steel_bodies(
        {{"cylinder", "far_size_mm = 1.0"}, {"coat", "far_size_mm = 0.05"}, {"substrate", "far_size_mm = 1.0"}}) +
    R"([boundary]
top    = { body = "cylinder", nearest_mm = [0, 6.02] }
round  = { body = "cylinder", type = "circle" }
face   = { body = "coat", nearest_mm = [0, 0.02] }
back   = { body = "coat", nearest_mm = [0, 0] }
under  = { body = "substrate", nearest_mm = [0, 0] }
bottom = { body = "substrate", nearest_mm = [0, -6] }
[contact.pad]
secondary = "face"
primary   = ["round"]
friction  = 0.0
fine_zone = { centre_mm = [0, 0], half_width_mm = 0.3, depth_mm = 0.1, size_mm = 0.01 }
[contact.bond]
secondary = "back"
primary   = ["under"]
friction  = 5.0
fine_zone = { centre_mm = [0, 0], half_width_mm = 0.3, depth_mm = 0.1, size_mm = 0.01 }
[support.holder]
edge     = "top"
x        = "fixed"
rotation = "fixed"
y        = { force_N_per_mm = -120.0, history = "press" }
[support.base]
edge = "bottom"
x    = "fixed"
y    = "fixed"
)" + support::press_step(5);

}  // namespace

// A loose shim that lifts off node by node must find its contact without a cut-back, however thin it is and however
// many nodes have to open, and in no more solves than an increment of any other contact takes.
TEST(Lifting, AShimUnderFriction) {
  for (const char* thickness : {"0.2", "0.02"}) {
    const auto problem = support::problem_from({{"shim.geo", shim(thickness)}, {"scene.toml", shim_scene}});
    auto state = sim::initial_state(problem);
    const auto summary = sim::run(problem, state, {});
    EXPECT_EQ(summary.status, sim::RunStatus::done) << thickness << ": " << summary.reason;
    EXPECT_EQ(summary.counts.cutbacks, 0) << thickness;
    EXPECT_LE(summary.counts.newton_iterations, 25) << thickness;
    EXPECT_NEAR(summary.contacts.at(0).normal_force / 200.0, 1.0, 1e-6) << thickness;
  }
}

// A coat that friction alone holds must carry Hertz' pressure where it is of its substrate's material.
TEST(Lifting, ACoatThatFrictionHolds) {
  const auto problem = support::problem_from({{"coated.geo", coated_geometry}, {"scene.toml", coated_scene}});
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  EXPECT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_EQ(summary.counts.cutbacks, 0);
  const double modulus = 200e3 / (2.0 * (1.0 - 0.3 * 0.3)),
               peak = std::sqrt(120.0 * modulus / (std::numbers::pi * 6.0));
  EXPECT_NEAR(summary.contacts.at(0).peak_pressure_MPa.value() / peak, 1.0, 0.01);
  EXPECT_NEAR(summary.contacts.at(1).normal_force / 120.0, 1.0, 1e-6);
}
