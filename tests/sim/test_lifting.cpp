#include <gtest/gtest.h>

#include "sim/run.hpp"
#include "support/problem.hpp"

using namespace reye;

namespace {

/// A shim of 12 x 0.2 mm that lies loose on a block, pressed on 2 mm of its top: most of it lifts off.
const char* const geometry = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {-6, -6, 0, 12, 6};
Rectangle(2) = {-6, 0, 0, 12, 0.2};
Physical Surface("block") = {1};
Physical Surface("shim") = {2};
Physical Curve("block_bottom") = {1};
Physical Curve("block_top") = {3};
Physical Curve("shim_bottom") = {5};
Physical Curve("shim_top") = {7};
)";

const char* const text = R"(geometry = ["shim.geo"]
[material.steel]
E_MPa = 200e3
nu    = 0.3
[body.block]
material = "steel"
mesh     = { far_size_mm = 0.5 }
[body.shim]
material = "steel"
mesh     = { far_size_mm = 0.1 }
[contact.bond]
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
[history]
press = [[0, 0], [1, 1]]
[[step]]
name = "press"
play = ["press"]
increments = 2
wear = false
)";

}  // namespace

// A loose shim that lifts off node by node must find its contact, however many nodes have to open, without a cut-back.
TEST(Lifting, AShimUnderFriction) {
  const auto problem = support::problem_from({{"shim.geo", geometry}, {"scene.toml", text}});
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  EXPECT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_EQ(summary.counts.cutbacks, 0);
  EXPECT_NEAR(summary.contacts.at(0).normal_force / 200.0, 1.0, 1e-6);
}
