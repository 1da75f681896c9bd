#include <cmath>

#include "sim/problem/records.hpp"
#include "wear_scene.hpp"

/// Supports that are springs, against closed forms: geo/sliding_block without friction, nu = 0, two blocks of 10 x 5
/// mm.
namespace reye::verification {

namespace {

struct SteelBlock {
  static constexpr double E = 200e3, width = 10.0, height = 5.0;  ///< MPa and mm
  static constexpr double stiffness = E * width / height;         ///< N/mm per mm
};

/// Two frictionless blocks of steel without lateral strain; `holder` and `base`: what the supports do along y.
Played spring_blocks(const std::string& holder, const std::string& base = "\"fixed\"", const Replacements& more = {}) {
  Replacements words{{"E_MPa = 200e6", "E_MPa = 200e3"},
                     {"traction_MPa = [0.0, 3.0]", "traction_MPa = [0.0, 0.0]"},
                     {"traction_MPa = [0.0, -3.0]", "traction_MPa = [0.0, 0.0]"},
                     {"motion_mm = 3.0e-7", "motion_mm = 0.0"},
                     {"friction  = 0.3", "friction  = 0.0"},
                     {"law = \"energy\", secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4",
                      "law = \"archard\", secondary_per_MPa = 1.0e-7"},
                     {"[[step]]\nname = \"slide\"\ncycles = 10\n", ""},
                     {"y        = { force_N_per_mm = -100.0, history = \"press\" }", "y        = " + holder},
                     {"y        = \"fixed\"", "y        = " + base}};
  words.insert(words.end(), more.begin(), more.end());
  return played(scene_text("sliding_block", words));
}

double series(std::initializer_list<double> stiffnesses) {
  double compliance = 0.0;
  for (double k : stiffnesses) compliance += 1.0 / k;
  return 1.0 / compliance;
}

void expect_force(const Played& run, double force, double accuracy) {
  EXPECT_NEAR(run.contact().normal_force / force, 1.0, accuracy);
  EXPECT_NEAR(run.records.back().support_forces[0].y() / -force, 1.0, accuracy);
  EXPECT_NEAR(run.records.back().support_forces[1].y() / force, 1.0, accuracy);
  EXPECT_LT(worst(run.surface(sim::Side::secondary).pressure_MPa, force / SteelBlock::width), accuracy);
}

}  // namespace

/// A spring whose far end moves presses with the stiffness of the series of spring and blocks.
TEST(Spring, FarEndMoves) {
  const double k = 1000.0;
  expect_force(spring_blocks("{ spring_N_per_mm2 = 1000.0, motion_mm = -0.1, history = \"press\" }"),
               0.1 * series({k, SteelBlock::stiffness, SteelBlock::stiffness}), 1e-9);
}

/// A force beside a spring is shared between the spring and the contact.
TEST(Spring, ForceBesideSpring) {
  const double k = 2e5, contact = series({SteelBlock::stiffness, SteelBlock::stiffness});
  const double u = 100.0 / (k + contact);
  expect_force(spring_blocks("{ spring_N_per_mm2 = 2e5, force_N_per_mm = -100.0, history = \"press\" }"), contact * u,
               1e-9);
}

/// A spring alone is a support: a block that floats on it goes down by force / k, and comes back with all that was put
/// in.
TEST(Spring, HoldsAFloatingBlockAndGivesItsEnergyBack) {
  const Played run =
      spring_blocks("{ force_N_per_mm = -100.0, history = \"press\" }", "{ spring_N_per_mm2 = 500.0 }",
                    {{"press = [[0.0, 0.0], [1.0, 1.0]]", "press = [[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]]"},
                     {"play = [\"press\"]\n", "play = [\"press\"]\nincrements = 8\n"},
                     {"[history]", "[output.probes]\nlow = { body = \"base\", at_mm = [5.0, -5.0] }\n[history]"}});
  ASSERT_EQ(run.records.size(), 8U);
  for (const auto& row : run.records) {
    const double force = 100.0 * (row.progress <= 0.5 ? 2.0 * row.progress : 2.0 - 2.0 * row.progress);
    EXPECT_NEAR(row.support_forces[1].y(), force, 1e-7) << row.progress;
  }
  EXPECT_NEAR(run.summary.probes.at("low").y(), 0.0, 1e-10);
}

/// A rigid block on a spring, pressed by an elastic one: springs in series.
TEST(Spring, UnderARigidBody) {
  const Played run =
      spring_blocks("{ motion_mm = -0.05, history = \"press\" }", "{ spring_N_per_mm2 = 3000.0 }",
                    {{"[body.base]                                  # the meshes do not match\nmaterial = \"cork\"\n",
                      "[body.base]\nrigid = true\n"},
                     {"mesh     = { element = \"quad\", far_size_mm = 0.7 }", ""}});
  expect_force(run, 0.05 * series({3000.0, SteelBlock::stiffness}), 1e-9);
}

/// A finitely strained block behind a spring: its stiffness differs by its strain, 1e-4, alone.
TEST(Spring, BehindANonlinearBody) {
  const Played run = spring_blocks("{ spring_N_per_mm2 = 1000.0, motion_mm = -0.1, history = \"press\" }", "\"fixed\"",
                                   {{"nu    = 0.0\n", "nu    = 0.0\nlaw = \"hencky\"\n"},
                                    {"[body.slider]\n", "[body.slider]\nkinematics = \"finite\"\n"}});
  expect_force(run, 0.1 * series({1000.0, SteelBlock::stiffness, SteelBlock::stiffness}), 2e-4);
}

/// What wears behind a spring is relieved by it: p falls by 1 / (1 + k_w K ds / b) in each implicit increment, K of the
/// series.
TEST(Spring, WearRelaxes) {
  const double k = 1000.0, K = series({k, SteelBlock::stiffness, SteelBlock::stiffness}),
               kappa = 1e-7 * K / SteelBlock::width * 1e5;
  const Played run =
      spring_blocks("{ spring_N_per_mm2 = 1000.0, motion_mm = -0.1, history = \"press\" }", "\"fixed\"",
                    {{"imposed_sliding_mm = 100.0", "imposed_sliding_mm = 1.0e6"},
                     {"geometry = [", "shape = \"off\"\ngeometry = ["},
                     {"wear = false\n", "wear = false\n\n[[step]]\nname = \"slide\"\nincrements = 10\ncycles = 1\n"}});
  expect_force(run, 0.1 * K / std::pow(1.0 + kappa, 10.0), 1e-8);
}

/// A spring turns by its moment over its stiffness, with the lever as the body has turned: c theta = F L cos(theta).
TEST(Spring, TurnsByItsMoment) {
  const std::string path = support::temporary_folder() + "reye_lever.geo";
  std::ofstream(path)
      << "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 4, 1};\nPhysical Surface(\"lever\") = {1};\n"
         "Physical Curve(\"end\") = {4};\n";
  const Played run =
      played("geometry = [\"" + path +
             "\"]\n[material.stiff]\nE_MPa = 2e12\nnu = 0.3\n[body.lever]\nmaterial = \"stiff\"\n"
             "mesh = { far_size_mm = 0.5 }\n[support.hinge]\nedge = \"end\"\nx = \"fixed\"\ny = \"fixed\"\n"
             "rotation = { spring_N_mm_per_mm = 50.0 }\n[load.tip]\npoint_mm = [4.0, 0.5]\nbody = \"lever\"\n"
             "force_N_per_mm = [0.0, 10.0]\nhistory = \"pull\"\n[history]\npull = [[0.0, 0.0], [1.0, 1.0]]\n"
             "[[step]]\nplay = [\"pull\"]\nincrements = 8\nwear = false\n");
  const double moment = -run.records.back().support_moments[0].value();  // of the lever on the spring
  EXPECT_NEAR(moment / (10.0 * 4.0 * std::cos(moment / 50.0)), 1.0, 1e-6);
  EXPECT_GT(moment, 25.0);
}

}  // namespace reye::verification
