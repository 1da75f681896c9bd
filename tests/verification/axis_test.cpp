#include <cmath>
#include <numbers>

#include "sim/problem/records.hpp"
#include "support/scene_words.hpp"
#include "wear_scene.hpp"

/// Contacts that reach the axis of axisymmetry, and sliding about it.
namespace reye::verification {

namespace {

const std::string axis_head = R"(analysis = "axisymmetric"
geometry = ["reye_axis.geo"]
)" + support::steel_bodies({{"upper", "far_size_mm = 0.5"}, {"lower", "far_size_mm = 0.5"}});

const std::string surface_names = R"(Physical Surface("upper") = {1};
Physical Surface("lower") = {2};
)";

/// A pin on a post, both of radius 2.
const std::string pin_geo = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 2, 1};
Rectangle(2) = {0, -1, 0, 2, 1};
)" + surface_names + R"(Physical Curve("pin_end") = {1};
Physical Curve("pin_top") = {3};
Physical Curve("post_bottom") = {5};
Physical Curve("post_top") = {7};
)";

const std::string spinning = axis_head + R"([contact.end]
secondary = "pin_end"
primary   = ["post_top"]
friction  = 0.3
imposed_turn_rad = 0.5
wear = { law = "energy", secondary_mm3_per_J = 1.0e-9, primary_mm3_per_J = 2.0e-9 }
[support.floor]
edge = "post_bottom"
y    = "fixed"
[load.weight]
edge         = "pin_top"
pressure_MPa = 10.0
[[step]]
name  = "spin"
cycles = 1
increments = 2
)";

Played spun(const Replacements& changes = {}) {
  std::ofstream(support::temporary_folder() + "reye_axis.geo") << pin_geo;
  return played(replaced(spinning, changes));
}

struct SpinningPin {
  static constexpr double mu = 0.3, p = 10.0, angle = 0.5, R = 2.0;  ///< MPa, rad and mm
};

/// A ball of radius 10 on a plate.
const std::string ball_geo = R"(SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0};
Point(2) = {3.420201433256687, 0.603073792140917, 0};
Point(3) = {3.420201433256687, 4, 0};
Point(4) = {0, 4, 0};
Point(5) = {0, 10, 0};
Circle(1) = {1, 5, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Rectangle(2) = {0, -6, 0, 8, 6};
)" + surface_names + R"(Physical Curve("round") = {1};
Physical Curve("ball_top") = {3};
Physical Curve("floor") = {5};
Physical Curve("plate") = {7};
)";

const std::string ball_on_plate = axis_head + R"([contact.end]
secondary = "plate"
primary   = ["round"]
friction  = 0.0
fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.9, depth_mm = 0.5, size_mm = 0.05 }
[support.floor]
edge = "floor"
x    = "fixed"
y    = "fixed"
[support.holder]
edge = "ball_top"
x    = "fixed"
y    = { force_N = -1833.0, history = "press" }
)" + support::press_step(4);

Played on_plate(const Replacements& changes = {}) {
  std::ofstream(support::temporary_folder() + "reye_axis.geo") << ball_geo;
  return played(replaced(ball_on_plate, changes));
}

const Replacements ball_secondary{
    {"secondary = \"plate\"\nprimary   = [\"round\"]", "secondary = \"round\"\nprimary   = [\"plate\"]"}};

}  // namespace

/// A pin that spins under even pressure dissipates mu p times the way of every ring, and wears so: dV = alpha mu p
/// angle r dA.
TEST(Axis, SpinningPin) {
  const Played run = spun();
  const double work = SpinningPin::mu * SpinningPin::p * SpinningPin::angle * 2.0 * std::numbers::pi *
                      std::pow(SpinningPin::R, 3) / 3.0;
  EXPECT_NEAR(run.contact().dissipated_energy / work, 1.0, 1e-4);  // the pin is wider under load by 1.5e-5
  EXPECT_NEAR(run.contact().secondary.worn_area / (1e-12 * work), 1.0, 1e-4);
  EXPECT_NEAR(run.contact().primary.worn_area / (2e-12 * work), 1.0, 1e-4);
  const auto& s = run.surface(sim::Side::secondary);
  for (std::size_t i = 0; i < s.node.size(); ++i) {
    EXPECT_NEAR(s.wear_depth_mm[i], 1e-12 * SpinningPin::mu * SpinningPin::p * SpinningPin::angle * s.x_mm[i], 1e-16);
    EXPECT_NEAR(s.shear_MPa[i], 0.0, 1e-9);
  }
}

/// Archard's law takes the way out of the plane as the energy law does, and a length as well as an angle.
TEST(Axis, SlidingOutOfThePlaneByEitherLaw) {
  const Replacements archard{{"friction  = 0.3\n", ""},
                             {"law = \"energy\", secondary_mm3_per_J = 1.0e-9, primary_mm3_per_J = 2.0e-9",
                              "law = \"archard\", secondary_per_MPa = 1.0e-12"}};
  EXPECT_NEAR(spun(archard).contact().secondary.worn_area / (1e-12 * SpinningPin::p * SpinningPin::angle * 2.0 *
                                                             std::numbers::pi * std::pow(SpinningPin::R, 3) / 3.0),
              1.0, 1e-4);
  const Played run = spun({{"imposed_turn_rad = 0.5", "imposed_out_of_plane_mm = 3.0"}});
  EXPECT_NEAR(run.contact().dissipated_energy /
                  (SpinningPin::mu * SpinningPin::p * 3.0 * std::numbers::pi * SpinningPin::R * SpinningPin::R),
              1.0, 1e-4);
}

/// A frictionless contact has no shear, no tangential force and dissipates nothing, at the node on the axis as
/// elsewhere, whichever side carries it.
TEST(Axis, FrictionlessHasNoShear) {
  for (const auto& roles : {Replacements{}, ball_secondary}) {
    const Played run = on_plate(roles);
    const auto& s = run.surface(sim::Side::secondary);
    for (std::size_t i = 0; i < s.node.size(); ++i) EXPECT_NEAR(s.shear_MPa[i], 0.0, 1e-6);
    EXPECT_NEAR(run.contact().tangential_force, 0.0, 1e-6);
    EXPECT_EQ(run.contact().dissipated_energy, 0.0);
  }
}

/// Where a ball lies in a cup, pressed on by normals of all directions, the normal force is the resultant, which its
/// stem feels, and not the integral of the pressure; without friction nothing acts across it and no energy is
/// dissipated, worn or not.
TEST(Axis, NormalForceIsTheResultant) {
  const Played run =
      played(scene_text("ball_in_cup", {{"cycles = 1e7\njump = { tolerance = 0.01 }", "cycles = 2e5\njump = 1e5"}}));
  EXPECT_GT(run.contact().contact_half_width_mm.value(), 10.0);
  for (const auto& row : run.records)
    EXPECT_NEAR(row.contacts[0].normal_force, std::abs(row.support_forces[0].y()), 1e-6);
  EXPECT_NEAR(run.contact().normal_force, 2000.0, 1e-3);
  EXPECT_NEAR(run.contact().tangential_force, 0.0, 1e-6);
  EXPECT_EQ(run.contact().dissipated_energy, 0.0);
}

/// With friction, too, nothing slides at the axis: no shear acts there.
TEST(Axis, FrictionLeavesNoShearOnIt) {
  const Played run = on_plate({{"friction  = 0.0", "friction  = 0.3"}});
  const auto& s = run.surface(sim::Side::secondary);
  EXPECT_GT(s.pressure_MPa.front(), 1000.0);
  EXPECT_NEAR(s.shear_MPa.front() / s.pressure_MPa.front(), 0.0, 1e-9);
}

/// The half width of a contact that reaches the axis goes from there to its edge: Hertz' 0.5 mm.
TEST(Axis, HalfWidthFromTheAxis) { EXPECT_NEAR(on_plate().contact().contact_half_width_mm.value() / 0.5, 1.0, 0.02); }

/// Wear by imposed sliding leaves no peak on the axis.
TEST(Axis, WornByImposedSliding) {
  const Played run = on_plate(
      {{"friction  = 0.0",
        "friction = 0.1\nimposed_sliding_mm = 10.0\nwear = { law = \"energy\", secondary_mm3_per_J = 1.0e-4 }"},
       {"increments = 4\nwear = false\n",
        "increments = 4\nwear = false\n[[step]]\nname = \"rub\"\ncycles = 200\njump = 20\n"}});
  const auto& pressure = run.surface(sim::Side::secondary).pressure_MPa;
  EXPECT_NEAR(pressure[0] / pressure[2], 1.0, 0.1);
  EXPECT_NEAR(pressure[1] / pressure[2], 1.0, 0.1);
}

}  // namespace reye::verification
