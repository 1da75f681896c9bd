#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/errors.hpp"
#include "mesh/quality.hpp"
#include "sim/study/run.hpp"
#include "solver/system.hpp"
#include "support/problem.hpp"

using namespace reye;

namespace {

struct Outcome {
  sim::Problem problem;
  sim::State state;
  sim::Summary summary;
  std::vector<sim::IncrementRecord> rows{};
  const contact::ContactState& bond() const { return state.solution.contacts[problem.contacts.size()]; }
};

Outcome bonded(const std::string& geometry, const std::string& scene) {
  Outcome outcome{
      support::problem_from({{"part.geo", geometry}, {"scene.toml", "geometry = [\"part.geo\"]\n" + scene}}), {}, {}};
  outcome.state = sim::initial_state(outcome.problem);
  sim::Observer observer;
  observer.increment = [&](const sim::IncrementRecord& row) { outcome.rows.push_back(row); };
  outcome.summary = sim::run(outcome.problem, outcome.state, observer);
  return outcome;
}

/// Two blocks of 4 mm, one on the other, whose meshes do not match.
const char* const strip = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 4, 2};
Rectangle(2) = {0, 2, 0, 4, 1};
Physical Surface("lower") = {1};
Physical Surface("upper") = {2};
Physical Curve("bottom") = {1};
Physical Curve("lower_right") = {2};
Physical Curve("lower_top") = {3};
Physical Curve("lower_left") = {4};
Physical Curve("upper_bottom") = {5};
Physical Curve("upper_right") = {6};
Physical Curve("top") = {7};
Physical Curve("upper_left") = {8};
)";

std::string materials(double nu) {
  const auto text = std::to_string(nu);
  return "[material.soft]\nE_MPa = 1000.0\nnu = " + text + "\n[material.stiff]\nE_MPa = 10000.0\nnu = " + text + "\n";
}

std::string bodies(int order, const std::string& secondary, const std::string& primary) {
  const auto o = "order = " + std::to_string(order);
  return "[body.lower]\nmaterial = \"soft\"\nkinematics = \"small\"\n" + o +
         "\nmesh = { far_size_mm = 0.5 }\n"
         "[body.upper]\nmaterial = \"stiff\"\nkinematics = \"small\"\n" +
         o +
         "\nmesh = { far_size_mm = 0.37 }\n"
         "[bond.glue]\nsecondary = \"" +
         secondary + "\"\nprimary = [\"" + primary + "\"]\n";
}

/// 3 MPa of shear and 20 MPa of tension: lateral strain is left out, so that one stress is in both.
const char* const pulled = R"([support.base]
edge = "bottom"
x = "fixed"
y = "fixed"
[load.pull]
edge = "top"
traction_MPa = [3.0, 20.0]
history = "press"
[load.lower_right]
edge = "lower_right"
traction_MPa = [0.0, 3.0]
history = "press"
[load.lower_left]
edge = "lower_left"
traction_MPa = [0.0, -3.0]
history = "press"
[load.upper_right]
edge = "upper_right"
traction_MPa = [0.0, 3.0]
history = "press"
[load.upper_left]
edge = "upper_left"
traction_MPa = [0.0, -3.0]
history = "press"
[output.probes]
corner = { body = "upper", at_mm = [4, 3] }
[history]
press = [[0, 0], [1, 1]]
[[step]]
name = "pull"
play = ["press"]
increments = 2
wear = false
)";

}  // namespace

// Across a bond of meshes that do not match, one stress must pass exactly, in tension and shear, whichever side is
// secondary.
TEST(Bonds, PatchOfTensionAndShear) {
  for (const int order : {1, 2})
    for (const bool swapped : {false, true}) {
      const char *above = "upper_bottom", *below = "lower_top";
      const auto o =
          bonded(strip, materials(0.0) + bodies(order, swapped ? below : above, swapped ? above : below) + pulled);
      ASSERT_EQ(o.summary.status, sim::RunStatus::done) << o.summary.reason;
      const double compliance = 2.0 / 1000.0 + 1.0 / 10000.0;
      const auto& u = o.summary.probes.at("corner");
      EXPECT_NEAR(u.x() / (2.0 * 3.0 * compliance), 1.0, 1e-10) << order << swapped;
      EXPECT_NEAR(u.y() / (20.0 * compliance), 1.0, 1e-10) << order << swapped;
      int carrying = 0;
      for (std::size_t j = 0; j < o.bond().lambda.size(); ++j) {
        if (o.bond().status[j] == contact::ContactStatus::inactive) continue;
        ++carrying;
        const double sign = swapped ? -1.0 : 1.0;  // minus the traction of the secondary side
        EXPECT_NEAR(o.bond().lambda[j].x(), 3.0 * sign, 1e-8) << order << swapped;
        EXPECT_NEAR(o.bond().lambda[j].y(), 20.0 * sign, 1e-8) << order << swapped;
      }
      EXPECT_GE(carrying, 5);
    }
}

// Summary and history must report the tension and shear of a bond, their means, and the most of the run where the load
// falls again.
TEST(Bonds, TellWhatTheyCarry) {
  const auto falls =
      std::string(pulled).replace(std::string(pulled).find("[[0, 0], [1, 1]]"), 16, "[[0, 0], [0.5, 2], [1, 1]]");
  const auto o = bonded(strip, materials(0.0) + bodies(1, "upper_bottom", "lower_top") + falls);
  ASSERT_EQ(o.summary.status, sim::RunStatus::done) << o.summary.reason;
  ASSERT_EQ(o.summary.bonds.size(), 1U);
  const auto& [name, end, most] = o.summary.bonds[0];
  EXPECT_EQ(name, "glue");
  EXPECT_NEAR(end.tension.MPa, 20.0, 1e-8);
  EXPECT_NEAR(end.mean_tension_MPa, 20.0, 1e-8);
  EXPECT_NEAR(end.shear.MPa, 3.0, 1e-8);
  EXPECT_NEAR(end.mean_shear_MPa, 3.0, 1e-8);
  EXPECT_NEAR(most.tension.MPa, 40.0, 1e-8);
  EXPECT_NEAR(most.shear.MPa, 6.0, 1e-8);
  EXPECT_NEAR(most.mean_tension_MPa, 40.0, 1e-8);
  EXPECT_NEAR(most.tension.at_mm.y(), 2.0, 1e-12);
  ASSERT_EQ(o.rows.size(), 2U);
  EXPECT_NEAR(o.rows[0].bonds.at(0).tension.MPa, 40.0, 1e-8);
  EXPECT_NEAR(o.rows[1].bonds.at(0).shear.MPa, 3.0, 1e-8);
}

// The peak at a free end of a bond between two materials, which grows as elements get shorter, must be named so; one
// that a load makes in the middle, and one on a line of symmetry, must not.
TEST(Bonds, APeakAtAFreeEndIsNamed) {
  const auto load = [](const std::string& where) {
    return "[support.base]\nedge = \"bottom\"\nx = \"fixed\"\ny = \"fixed\"\n[load.pull]\nedge = \"top\"\n" + where +
           "traction_MPa = [0.0, 20.0]\nhistory = \"press\"\n[history]\npress = [[0, 0], [1, 1]]\n[[step]]\nplay = "
           "[\"press\"]\n"
           "increments = 1\nwear = false\n";
  };
  const std::string symmetric =
      "[support.left]\nedge = \"lower_left\"\nx = \"fixed\"\n[support.left_above]\nedge = \"upper_left\"\nx = "
      "\"fixed\"\n";
  const auto peak = [&](const std::string& more) {
    const auto o = bonded(strip, materials(0.3) + bodies(1, "upper_bottom", "lower_top") + more);
    EXPECT_EQ(o.summary.status, sim::RunStatus::done) << o.summary.reason;
    return o.summary.bonds.at(0).end.tension;
  };
  const auto everywhere = peak(load(""));
  EXPECT_TRUE(everywhere.at_end);
  EXPECT_TRUE(everywhere.at_mm.x() < 0.9 || everywhere.at_mm.x() > 3.1) << everywhere.at_mm.x();
  const auto middle = peak(load("interval_mm = [1.7, 2.3]\n"));
  EXPECT_FALSE(middle.at_end);
  EXPECT_NEAR(middle.at_mm.x(), 2.0, 0.4);
  const auto half = peak(load("interval_mm = [0.0, 0.5]\n") + symmetric);
  EXPECT_FALSE(half.at_end);
  EXPECT_LT(half.at_mm.x(), 0.5);
}

// Bodies that are bonded to one another are one linear body: each increment must take one solve, and one to see that it
// is met.
TEST(Bonds, AreLinear) {
  const auto o = bonded(strip, materials(0.3) + bodies(1, "upper_bottom", "lower_top") + pulled);
  ASSERT_EQ(o.summary.status, sim::RunStatus::done) << o.summary.reason;
  EXPECT_LE(o.summary.counts.newton_iterations, 4);
}

// A coat of 20 um on a block that cannot widen must give by p h (1 + nu) (1 - 2 nu) / (E (1 - nu)), and so must the
// block.
TEST(Bonds, ACoatUnderUniformPressure) {
  const auto o = bonded(R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Rectangle(2) = {0, 1, 0, 1, 0.02};
Physical Surface("block") = {1};
Physical Surface("coat") = {2};
Physical Curve("bottom") = {1};
Physical Curve("block_right") = {2};
Physical Curve("block_top") = {3};
Physical Curve("block_left") = {4};
Physical Curve("back") = {5};
Physical Curve("coat_right") = {6};
Physical Curve("face") = {7};
Physical Curve("coat_left") = {8};
)",
                        R"([material.steel]
E_MPa = 200e3
nu = 0.3
[material.polymer]
E_MPa = 3e3
nu = 0.4
[body.block]
material = "steel"
mesh = { far_size_mm = 0.1 }
[body.coat]
material = "polymer"
mesh = { far_size_mm = 0.03 }
[bond.glue]
secondary = "back"
primary = ["block_top"]
[support.base]
edge = "bottom"
y = "fixed"
[support.block_left]
edge = "block_left"
x = "fixed"
[support.block_right]
edge = "block_right"
x = "fixed"
[support.coat_left]
edge = "coat_left"
x = "fixed"
[support.coat_right]
edge = "coat_right"
x = "fixed"
[load.press]
edge = "face"
pressure_MPa = 50.0
history = "press"
[output.probes]
face = { body = "coat", at_mm = [0, 1.02] }
foot = { body = "coat", at_mm = [0, 1] }
[history]
press = [[0, 0], [1, 1]]
[[step]]
name = "press"
play = ["press"]
increments = 1
wear = false
)");
  ASSERT_EQ(o.summary.status, sim::RunStatus::done) << o.summary.reason;
  const auto given = [](double h, double E, double nu) {
    return 50.0 * h * (1.0 + nu) * (1.0 - 2.0 * nu) / (E * (1.0 - nu));
  };
  const double foot = o.summary.probes.at("foot").y(), face = o.summary.probes.at("face").y();
  EXPECT_NEAR(foot / -given(1.0, 200e3, 0.3), 1.0, 1e-8);
  EXPECT_NEAR((face - foot) / -given(0.02, 3e3, 0.4), 1.0, 1e-8);
  EXPECT_EQ(o.summary.bonds.at(0).most.tension.MPa, 0.0);  // nothing pulls
  EXPECT_NEAR(o.summary.bonds.at(0).end.mean_tension_MPa, -50.0, 1e-6);
}

// A liner bonded into a hub must turn with it by any angle and feel nothing, though neither facets nor nodes match.
TEST(Bonds, TurnWithTheBody) {
  const auto o = bonded(R"(SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 8};
Disk(2) = {0, 0, 0, 5};
Disk(3) = {0, 0, 0, 3};
BooleanDifference(4) = { Surface{1}; Delete; }{ Surface{2}; };
BooleanDifference(5) = { Surface{2}; Delete; }{ Surface{3}; Delete; };
Physical Surface("hub") = {4};
Physical Surface("liner") = {5};
)",
                        R"([material.steel]
E_MPa = 200e3
nu = 0.3
[body.hub]
at = [6.5, 0]
material = "steel"
mesh = { far_size_mm = 0.9 }
[body.liner]
at = [4, 0]
material = "steel"
mesh = { far_size_mm = 0.5 }
[boundary]
rim = { body = "hub", nearest_mm = [8, 0] }
seat = { body = "hub", nearest_mm = [5, 0] }
back = { body = "liner", nearest_mm = [5, 0] }
[bond.glue]
secondary = "back"
primary = ["seat"]
[support.drive]
edge = "rim"
rigid = true
x = "fixed"
y = "fixed"
rotation = { motion_rad = 2.0, history = "turn" }
[output.probes]
inside = { body = "liner", at_mm = [3, 0] }
[history]
turn = [[0, 0], [1, 1]]
[[step]]
name = "turn"
play = ["turn"]
increments = 4
wear = false
)");
  ASSERT_EQ(o.summary.status, sim::RunStatus::done) << o.summary.reason;
  const auto& u = o.summary.probes.at("inside");
  EXPECT_NEAR(u.x(), 3.0 * std::cos(2.0) - 3.0, 1e-9);
  EXPECT_NEAR(u.y(), 3.0 * std::sin(2.0), 1e-9);
  for (const auto& lambda : o.bond().lambda) EXPECT_LE(lambda.norm(), 1e-4);  // of a modulus of 2e5 MPa
}

// A coat of 20 um under a block that slides must end the run with its name and what is left of it before no element
// fits in, on elements of both kinds, with fixed blocks and under a tolerance; what it leaves is a whole mesh.
TEST(Bonds, ACoatWornThrough) {
  const char* cases[][3] = {{"quad", "0.1", "10"}, {"tri", "0.1", "{ tolerance = 0.02 }"}};
  for (const auto& [element, size, jump] : cases) {
    const std::string mesh = std::string("mesh = { element = \"") + element + "\", far_size_mm = ";
    const auto o = bonded(R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Rectangle(2) = {0, 1, 0, 1, 0.02};
Rectangle(3) = {0, 1.02, 0, 1, 0.5};
Physical Surface("block") = {1};
Physical Surface("coat") = {2};
Physical Surface("slider") = {3};
Physical Curve("bottom") = {1};
Physical Curve("block_top") = {3};
Physical Curve("back") = {5};
Physical Curve("face") = {7};
Physical Curve("sole") = {9};
Physical Curve("top") = {11};
)",
                          "[material.steel]\nE_MPa = 200e3\nnu = 0.3\n[body.block]\nmaterial = \"steel\"\n" + mesh +
                              "0.25 }\n[body.slider]\nmaterial = \"steel\"\n" + mesh +
                              "0.25 }\n[body.coat]\nmaterial = \"steel\"\n" + mesh + size +
                              " }\n[[step]]\nplay = [\"press\"]\nwear = false\n" +
                              "[[step]]\nname = \"wear\"\ncycles = 400\njump = " + jump + R"(
[contact.pad]
secondary = "face"
primary = ["sole"]
imposed_sliding_mm = 1000.0
wear = { law = "archard", secondary_per_MPa = 1e-8 }
[bond.glue]
secondary = "back"
primary = ["block_top"]
[support.base]
edge = "bottom"
x = "fixed"
y = "fixed"
[support.holder]
edge = "top"
x = "fixed"
rotation = "fixed"
y = { force_N_per_mm = -20.0, history = "press" }
[history]
press = [[0, 0], [1, 1]]
)");
    const auto where = std::string(element) + ' ' + size + ' ' + jump;
    EXPECT_EQ(o.summary.status, sim::RunStatus::failed) << where;
    EXPECT_NE(o.summary.reason.find("body coat is worn by 0.01"), std::string::npos)
        << where << ": " << o.summary.reason;
    EXPECT_NE(o.summary.reason.find("mm of the 0.02 mm that it measured at cycle 0, 0.0"), std::string::npos)
        << where << ": " << o.summary.reason;
    EXPECT_GE(o.summary.contacts.at(0).secondary.max_depth_mm, 0.018) << where;
    EXPECT_GT(mesh::poorest_cell(o.state.shapes[1]->mesh).scaled_jacobian, 0.0) << where;
  }
}
