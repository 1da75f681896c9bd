#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "disc_scene.hpp"
#include "played.hpp"
#include "sim/place/warn_setup.hpp"

using namespace reye;
using test::Changes;
using test::Kinds;
using test::kinds_of;

namespace {

Kinds of_blocks(const Changes& changes) {
  return kinds_of(test::problem_of(test::with(test::block_scene, changes)).warnings);
}

std::string refusal(const std::string& scene) {
  try {
    test::problem_of(scene);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "not refused";
}

const char* const limit_and_history = "[limit.life]\ncontact = \"pad\"\ndepth_mm = 1.0\n[history]";

}  // namespace

// Scenes without a mistake must give no warning.
TEST(WarnSetup, NothingWithoutCause) {
  EXPECT_EQ(of_blocks({{"[history]", limit_and_history}}), Kinds{});
  EXPECT_EQ(kinds_of(test::disc_problem().warnings), Kinds{});
}

// Supports that ask different things of one place must be refused with the line of the later one and the name of the
// other.
TEST(WarnSetup, SupportsThatContradict) {
  const std::string again =
      "[support.again]\nedge = \"slider_top\"\nx = { motion_mm = 0.02, history = \"stroke\" }\n[history]";
  const std::string told = refusal(test::with(test::block_scene, {{"[history]", again}}));
  EXPECT_NE(told.find(": support.again.x: the node at ("), std::string::npos) << told;
  EXPECT_NE(told.find("support \"holder\""), std::string::npos) << told;
  const std::string normal =
      "[support.again]\nedge = \"base_bottom\"\nnormal = { motion_mm = 0.02, history = \"stroke\" }\n[history]";
  const std::string along = refusal(test::with(test::block_scene, {{"[history]", normal}}));
  EXPECT_NE(along.find(": support.again.normal: "), std::string::npos) << along;
}

// A rigid ring moved or pushed along the radius must be refused by its support's name.
TEST(WarnSetup, RigidRing) {
  for (const std::string motion :
       {"{ motion_mm = -0.01, history = \"press\" }", "{ force_N = -1e4, history = \"press\" }"}) {
    const std::string told = refusal(test::with(
        "analysis = \"axisymmetric\"\n" + std::string(test::block_scene),
        {{"[body.slider]\nmaterial = \"steel\"\nmesh     = { far_size_mm = 0.5 }", "[body.slider]\nrigid = true"},
         {"secondary = \"slider_bottom\"", "secondary = \"base_top\""},
         {"primary   = [\"base_top\"]", "primary   = [\"slider_bottom\"]"},
         {", primary_mm3_per_J = 2.0e-5", ""},
         {"{ motion_mm = 0.01, history = \"stroke\" }", motion},
         {"force_N_per_mm", "force_N"}}));
    EXPECT_NE(told.find(": support.holder.x: a rigid ring cannot move radially"), std::string::npos) << told;
  }
}

// Bodies in contact that no support holds along the load must be refused by their names, though each alone is supported
// by the other.
TEST(WarnSetup, HeldByNothing) {
  const std::string told = refusal(
      test::with(test::block_scene,
                 {{"y        = \"fixed\"\nrotation = \"fixed\"\n[history]", "rotation = \"fixed\"\n[history]"}}));
  EXPECT_NE(told.find("translation along y of slider and base together is free: no support of any of them holds it"),
            std::string::npos)
      << told;
}

// A support that loses one corner to a rigid edge which is free there must be reported, and the rest of it acts.
TEST(WarnSetup, LostCorner) {
  const std::string side = "[support.side]\nedge = \"base_left\"\nx = \"fixed\"\n[history]";
  auto scene = test::with(
      test::block_scene,
      {{"[history]", side}, {"edge     = \"base_bottom\"\nx        = \"fixed\"", "edge     = \"base_bottom\""}});
  const auto problem = support::problem_from(
      {{"blocks.geo", test::two_blocks(0.0) + "Physical Curve(\"base_left\") = {8};\n"}, {"scene.toml", scene}});
  EXPECT_EQ(kinds_of(problem.warnings), Kinds{"support, support side"});
}

// A step that wears without cycles, beside a limit or with a jump, must be reported; without either it is a load step.
TEST(WarnSetup, StepWithoutCycles) {
  const Changes no_cycles{{"cycles = 40\n", ""}};
  EXPECT_EQ(of_blocks(no_cycles), Kinds{"no_cycles, step wear"});
  EXPECT_EQ(of_blocks({{"cycles = 40\njump = 10\n", ""}, {"[history]", limit_and_history}}),
            Kinds{"no_cycles, step wear"});
  EXPECT_EQ(of_blocks({{"cycles = 40\njump = 10\n", ""}}), Kinds{});
}

// Cycles that play no history which anything follows must be reported.
TEST(WarnSetup, CyclesThatPlayNothing) {
  EXPECT_EQ(of_blocks({{"name = \"wear\"\nplay = [\"stroke\"]", "name = \"wear\""},
                       {"play = [\"press\"]", "play = [\"press\", \"stroke\"]"}}),
            Kinds{"plays_nothing, step wear"});
}

// One increment for each stroke of a cycle must be reported; one more must not.
TEST(WarnSetup, OneIncrementAStroke) {
  EXPECT_EQ(of_blocks({{"increments = 8", "increments = 1"}}), Kinds{"increments, step wear"});
  EXPECT_EQ(of_blocks({{"increments = 8", "increments = 5"}}), Kinds{});
}

// A fine zone that lies beside the place where the sides touch must be reported before the run.
TEST(WarnSetup, FineZoneBesideTheContact) {
  const auto found = test::disc_problem({{"centre_mm = [0.0, 0.0]", "centre_mm = [0.4, 0.0]"}}, "0.9").warnings;
  EXPECT_EQ(kinds_of(found), (Kinds{"fine_zone, contact pad", "resolution, contact pad"}));
  EXPECT_NE(found[0].text.find("(0.4, 0)"), std::string::npos) << found[0].text;
}

// Where load and radii are known, the elements across by Hertz must be counted: 2 a = 0.0527 mm on 0.015 mm are 3.5.
TEST(WarnSetup, ElementsAcrossByHertz) {
  const auto found = test::disc_problem({{"size_mm = 0.005", "size_mm = 0.015"}}).warnings;
  ASSERT_EQ(kinds_of(found), Kinds{"resolution, contact pad"});
  EXPECT_NEAR(found[0].severity, 8.0 / 3.51, 0.1);
}

// Facets of a shaft in a bush, of a sagitta that the load does not press flat, must be reported; those of order 2 lie
// on the arc.
TEST(WarnSetup, FacetsInABush) {
  const std::string geo = R"(SetFactory("OpenCASCADE");
Disk(1) = {0, -0.05, 0, 10}; Disk(2) = {0, 0, 0, 13}; Disk(3) = {0, 0, 0, 10.05};
BooleanDifference(4) = { Surface{2}; Delete; }{ Surface{3}; Delete; };
Physical Surface("shaft") = {1}; Physical Curve("journal") = Boundary{ Surface{1}; };
Physical Surface("bush") = {4};
)";
  const std::string scene = R"(geometry = ["bush.geo"]
[material.pom]
E_MPa = 2800
nu = 0.38
[body.shaft]
rigid = true
ORDER
mesh = { far_size_mm = 0.4 }
[body.bush]
material = "pom"
ORDER
mesh = { far_size_mm = 0.4 }
[boundary]
bore = { body = "bush", nearest_mm = [0.0, -10.05] }
outside = { body = "bush", nearest_mm = [0.0, -13.0] }
[contact.bearing]
secondary = "bore"
primary = ["journal"]
[support.housing]
edge = "outside"
x = "fixed"
y = "fixed"
[support.shaft]
edge = "journal"
x = "fixed"
y = { force_N_per_mm = -10.0 }
rotation = "fixed"
[[step]]
wear = false
)";
  const auto of = [&](const std::string& order) {
    auto text = scene;
    for (auto at = text.find("ORDER"); at != std::string::npos; at = text.find("ORDER")) text.replace(at, 5, order);
    return kinds_of(support::problem_from({{"bush.geo", geo}, {"scene.toml", text}}).warnings);
  };
  EXPECT_EQ(of("order = 1"), Kinds{"facets, contact bearing"});
  EXPECT_EQ(of("order = 2"), Kinds{});
}

// A rotation that would take more increments than any run plays must be refused before they are listed.
TEST(WarnSetup, EndlessTurns) {
  const std::string turned = "rotation = { motion_rad = 4294967296.0, history = \"press\" }";
  const auto text = refusal(test::with(test::block_scene, {{"rotation = \"fixed\"", turned}}));
  EXPECT_NE(text.find("step[0] = \"press\": its rotations take 1.432e+10 increments of at most 0.3 rad"), text.npos)
      << text;
}
