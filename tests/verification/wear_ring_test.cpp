#include <cmath>

#include "wear_scene.hpp"

/// Wear in axisymmetry: volumes carry 2 pi r.
namespace reye::verification {

namespace {

const std::string rings_geo = R"(// A half-round ring of radius 3 about r = 10 on a flat ring.
SetFactory("OpenCASCADE");
Point(1) = {7, 3, 0};
Point(2) = {10, 0, 0};
Point(3) = {13, 3, 0};
Point(4) = {10, 3, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }
Point(5) = {6, -4, 0};
Point(6) = {14, -4, 0};
Point(7) = {14, 0, 0};
Point(8) = {6, 0, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 5};
Curve Loop(2) = {4, 5, 6, 7};
Plane Surface(2) = {2};
Physical Surface("ring") = {1};
Physical Surface("plate") = {2};
Physical Curve("ring_round") = {1, 2};
Physical Curve("ring_top") = {3};
Physical Curve("plate_bottom") = {4};
Physical Curve("plate_top") = {6};
)";

const std::string rings_scene = R"(title    = "Half-round ring on a flat ring"
analysis = "axisymmetric"
geometry = ["reye_rings.geo"]

[material.copper]
E_MPa = 130e3
nu    = 0.3

[material.steel]
E_MPa = 210e3
nu    = 0.3

[body.ring]
material = "copper"
mesh     = { element = "quad", far_size_mm = 0.6 }

[body.plate]
material = "steel"
mesh     = { element = "quad", far_size_mm = 0.6 }

[contact.seat]
secondary = "plate_top"
primary   = ["ring_round"]
friction  = 0.1
wear      = { law = "archard", secondary_per_MPa = 1.0e-7, primary_per_MPa = 3.0e-7 }
imposed_sliding_mm = 10.0
fine_zone = { centre_mm = [10.0, 0.0], half_width_mm = 0.6, depth_mm = 0.4, size_mm = 0.05 }

[support.holder]
edge = "ring_top"
x    = "fixed"
y    = { force_N = -100000.0, history = "press" }

[support.floor]
edge = "plate_bottom"
x    = "fixed"
y    = "fixed"

[history]
press = [[0.0, 0.0], [1.0, 1.0]]

[[step]]
name = "press"
play = ["press"]
increments = 3
wear = false

[[step]]
name = "slide"
cycles = 8
)";

}  // namespace

/// Removed volume is coefficient x work on both rings, and the work is k F s but for the slope of the surface.
TEST(WearRing, BookOfBothSides) {
  std::ofstream(support::temporary_folder() + "reye_rings.geo") << rings_geo;
  const Played run = played(rings_scene);
  const auto& c = run.contact();
  EXPECT_LT(c.ledger_relative_error.value(), 1e-9);
  EXPECT_NEAR(c.normal_force / 1e5, 1.0, 2e-3);
  EXPECT_NEAR(c.primary.worn_area / c.secondary.worn_area, 3.0, 1e-9);
  EXPECT_NEAR(c.secondary.worn_area / (1e-7 * 1e5 * 80.0), 1.0, 5e-3);
  EXPECT_GT(c.secondary.max_depth_mm, 1e-3);
}

}  // namespace reye::verification
