#include <gtest/gtest.h>

#include "sim/study/run.hpp"
#include "support/problem.hpp"

using namespace reye;

namespace {

sim::IncrementRecord last_row(const sim::Problem& problem, sim::Summary* told = nullptr) {
  sim::IncrementRecord row;
  auto state = sim::initial_state(problem);
  sim::Observer watch;
  watch.increment = [&](const sim::IncrementRecord& r) { row = r; };
  const auto summary = sim::run(problem, state, watch);
  EXPECT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  if (told) *told = summary;
  return row;
}

const std::string table_geo = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 4, 1};
Rectangle(2) = {0, -1, 0, 1, 1};
Rectangle(3) = {3, -1, 0, 1, 1};
Physical Surface("table") = {1}; Physical Surface("left") = {2}; Physical Surface("right") = {3};
Physical Curve("table_bottom") = {1}; Physical Curve("table_top") = {3};
Physical Curve("left_bottom") = {5}; Physical Curve("left_top") = {7};
Physical Curve("right_bottom") = {9}; Physical Curve("right_top") = {11};
)";

const std::string table_scene = R"(geometry = ["table.geo"]
[material.steel]
E_MPa = 200e3
nu    = 0.3
[body]
table = { material = "steel", mesh = { far_size_mm = 0.5 } }
left  = { material = "steel", mesh = { far_size_mm = 0.4 } }
right = { material = "steel", mesh = { far_size_mm = 0.4 } }
[contact.first]
secondary = "left_top"
primary   = ["table_bottom"]
friction  = 0.3
wear      = { law = "energy", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5 }
[contact.second]
secondary = "right_top"
primary   = ["table_bottom"]
friction  = 0.1
wear      = { law = "energy", secondary_mm3_per_J = 6.0e-5 }
[support.holder]
edge     = "table_top"
x        = { motion_mm = 0.01, history = "stroke" }
y        = { force_N_per_mm = -20.0, history = "press" }
rotation = "fixed"
[support.floors]
edge     = "left_bottom"
x        = "fixed"
y        = "fixed"
[support.other]
edge     = "right_bottom"
x        = "fixed"
y        = "fixed"
rotation = "fixed"
[history]
press  = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]
[[step]]
play = ["press"]
wear = false
[[step]]
play = ["stroke"]
increments = 8
cycles = 4
)";

}  // namespace

// A row must report for every contact what the summary reports for it at the end, and the first columns the largest and
// the sum of them.
TEST(Rows, TellOfEveryContact) {
  sim::Summary summary;
  const auto row = last_row(support::problem_from({{"table.geo", table_geo}, {"scene.toml", table_scene}}), &summary);
  ASSERT_EQ(row.contacts.size(), 2U);
  double energy = 0.0, pressure = 0.0;
  for (std::size_t c = 0; c < 2; ++c) {
    const auto &own = row.contacts[c], &other = row.contacts[1 - c];
    EXPECT_NEAR(own.normal_force, summary.contacts[c].normal_force, 1e-9);
    EXPECT_NEAR(own.tangential_force, summary.contacts[c].tangential_force, 1e-9);
    EXPECT_NEAR(own.depth_max_secondary_mm, summary.contacts[c].secondary.max_depth_mm, 1e-12);
    EXPECT_NEAR(own.depth_max_primary_mm, summary.contacts[c].primary.max_depth_mm, 1e-12);
    EXPECT_NEAR(own.energy_mJ, summary.contacts[c].dissipated_energy, 1e-12);
    EXPECT_NE(own.energy_mJ, other.energy_mJ);
    energy += own.energy_mJ;
    pressure = std::max(pressure, own.pressure_max_MPa);
  }
  EXPECT_NEAR(row.contacts[0].normal_force + row.contacts[1].normal_force, 20.0, 1e-3);  // the surfaces lean
  EXPECT_EQ(row.energy_mJ, energy);
  EXPECT_EQ(row.pressure_max_MPa, pressure);
  EXPECT_EQ(row.contacts[1].depth_max_primary_mm, 0.0);
}

// The moment of a rigid edge must be that which balances a load beside its middle; an edge that is held node by node
// has none.
TEST(Rows, TellTheMomentOfARigidEdge) {
  const std::string geo =
      "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 4, 1};\nPhysical Surface(\"lever\") = {1};\n"
      "Physical Curve(\"end\") = {4};\n";
  const auto scene = [](const std::string& rotation) {
    return "geometry = [\"lever.geo\"]\n[material.steel]\nE_MPa = 200e3\nnu = 0.3\n[body.lever]\nmaterial = \"steel\"\n"
           "mesh = { far_size_mm = 0.5 }\n[support.clamp]\nedge = \"end\"\nx = \"fixed\"\ny = \"fixed\"\n" +
           rotation +
           "[load.tip]\npoint_mm = [4.0, 1.0]\nbody = \"lever\"\nforce_N_per_mm = [3.0, 10.0]\n[[step]]\nwear = "
           "false\n";
  };
  const auto rigid =
      last_row(support::problem_from({{"lever.geo", geo}, {"scene.toml", scene("rotation = \"fixed\"\n")}}));
  EXPECT_NEAR(rigid.support_forces[0].x(), -3.0, 1e-8);
  EXPECT_NEAR(rigid.support_forces[0].y(), -10.0, 1e-8);
  ASSERT_TRUE(rigid.support_moments[0].has_value());
  EXPECT_NEAR(*rigid.support_moments[0], -(4.0 * 10.0 - 0.5 * 3.0), 1e-7);  // about the middle of the edge, (0, 0.5)
  const auto by_node = last_row(support::problem_from({{"lever.geo", geo}, {"scene.toml", scene("")}}));
  EXPECT_FALSE(by_node.support_moments[0].has_value());
}
