#pragma once
#include <string>

/// Small scenes for the command: wearing contacts of a second, and two blocks that show errors of geometry.
namespace reye::test {

/// Half disc R = 1 on a block 2 x 1; two load increments, four blocks of 16 increments.
inline const char* const wearing_geo = R"(SetFactory("OpenCASCADE");
Point(1) = {-1, 1, 0};
Point(2) = {0, 0, 0};
Point(3) = {1, 1, 0};
Point(4) = {0, 1, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }
Rectangle(2) = {-1, -1, 0, 2, 1};
Physical Surface("disc") = {1};
Physical Surface("flat") = {2};
Physical Curve("round") = {1, 2};
Physical Curve("top") = {3};
Physical Curve("bottom") = {4};
Physical Curve("face") = {6};
)";

/// The bodies of both scenes of the disc.
inline const std::string disc_on_flat = R"(geometry = ["wearing.geo"]

[material.steel]
E_MPa = 200e3
nu    = 0.3

[body.disc]
material = "steel"
mesh     = { far_size_mm = 0.35, growth = 1.8 }

[body.flat]
material = "steel"
mesh     = { far_size_mm = 0.35, growth = 1.8 }

)";

inline const std::string wearing = "title    = \"Small wearing contact\"\n" + disc_on_flat + R"([contact.pad]
secondary = "face"
primary   = ["round"]
friction  = 0.5
wear      = { law = "energy", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5 }
fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.08, depth_mm = 0.02, size_mm = 0.008 }

[support.holder]
edge     = "top"
x        = "fixed"
rotation = "fixed"
y        = { force_N_per_mm = -60.0, history = "press" }

[support.shaker]
edge     = "bottom"
y        = "fixed"
rotation = "fixed"
x        = { motion_mm = 0.004, history = "stroke" }

[history]
press  = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]

[[step]]
name = "press"
play = ["press"]
increments = 2
wear = false

[[step]]
name = "wear"
play = ["stroke"]
increments = 16
cycles = 400
jump = 100

[limit.life]
contact  = "pad"
depth_mm = 2e-5

[output]
checkpoint_s = 0
frames = { every_cycles = 200 }
probes = { edge = { body = "flat", at_mm = [0.5, 0.0] } }
)";

/// The disc of the wearing contact, worn flat by imposed sliding: six blocks, both bodies remeshed and drawn after
/// each.
inline const std::string worn_pin = "title    = \"Small pin worn flat\"\n" + disc_on_flat + R"([contact.pad]
secondary = "round"
primary   = ["face"]
friction  = 0.3
imposed_sliding_mm = 1000.0
wear      = { law = "energy", secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 1.0e-5 }
fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.15, depth_mm = 0.05, size_mm = 0.015 }

[support.holder]
edge     = "top"
x        = "fixed"
rotation = "fixed"
y        = { force_N_per_mm = -20.0, history = "press" }

[support.base]
edge = "bottom"
x    = "fixed"
y    = "fixed"

[history]
press = [[0.0, 0.0], [1.0, 1.0]]

[[step]]
name = "press"
play = ["press"]
increments = 2
wear = false

[[step]]
name = "wear"
cycles = 6

[remesh]
every_blocks = 1

[output]
checkpoint_s = 0
frames = { every_cycles = 1 }
)";

/// A block 2 x 1 on one of 4 x 1, with names.
inline const char* const blocks_geo = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {1, 0, 0, 2, 1};
Rectangle(2) = {0, -1, 0, 4, 1};
Physical Surface("slider") = {1};
Physical Surface("base") = {2};
Physical Curve("slider_bottom") = {1};
Physical Curve("slider_right") = {2};
Physical Curve("slider_top") = {3};
Physical Curve("base_bottom") = {5};
Physical Curve("base_top") = {7};
Physical Curve("left") = {4, 8};
)";

inline const char* const blocks = R"(geometry = ["blocks.geo"]

[material.steel]
E_MPa = 200e3
nu    = 0.3

[body.slider]
material = "steel"
mesh     = { far_size_mm = 0.5 }

[body.base]
material = "steel"
mesh     = { far_size_mm = 0.5 }

[contact.pad]
secondary = "slider_bottom"
primary   = ["base_top"]
friction  = 0.3
wear      = { law = "energy", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5 }

[support.holder]
edge     = "slider_top"
x        = "fixed"
y        = { force_N_per_mm = -20.0, history = "press" }
rotation = "fixed"

[support.floor]
edge     = "base_bottom"
x        = "fixed"
y        = "fixed"
rotation = "fixed"

[history]
press = [[0.0, 0.0], [1.0, 1.0]]

[[step]]
play = ["press"]
wear = false
)";

}  // namespace reye::test
