#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "folder.hpp"
#include "scene/solid/solid_scene.hpp"

namespace reye::test {

/// A scene of solids that shows the whole grammar: a ball on a flat with a rigid stop, a quarter of it drawn.
inline constexpr const char* solid_example = R"(title    = "Ball on flat, a quarter"
analysis = "solid"
geometry = ["ball_on_flat.step"]
symmetry = ["ball_sx", "flat_sx"]

[material.steel]
E_MPa = 210e3
nu    = 0.3

[body.ball]
at       = [1.0, 1.0, 40.0]
material = "steel"
mesh     = { far_size_mm = 6.0 }

[body.flat]
name     = "Base plate"
material = "steel"
order    = 1

[body.stop]
at    = [0.0, 0.0, -60.0]
rigid = true

[face]
ball_contact = { body = "ball", type = "sphere" }
ball_top     = { body = "ball", box_mm = [-60.0, -60.0, 49.9, 60.0, 60.0, 50.1] }
flat_contact = { body = "flat", nearest_mm = [0.0, 0.0, 0.0] }
flat_bottom  = { body = "flat", box_mm = [-60, -60, -30.1, 60, 60, -29.9], type = "plane" }
stop_top     = { body = "stop", type = "plane" }

[contact.pad]
secondary = "flat_contact"
primary   = ["ball_contact"]
friction  = 0.3
fine_zone = [{ centre_mm = [0.0, 0.0, 0.0], radius_mm = 2.0, size_mm = 0.2 },
             { centre_mm = [5.0, 0.0, 0.0], half_widths_mm = [1.0, 2.0, 3.0], size_mm = 0.5 }]
imposed_sliding_mm = { direction = [0.0, 3.0, 0.0], value = 0.4, history = "rub" }
imposed_turn_rad   = [{ point_mm = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 2.0], value = 0.1, history = "rub" }]

[contact.stop]
secondary = "flat_bottom"
primary   = ["stop_top"]

[support.holder]
face       = "ball_top"
x          = "fixed"
y          = [{ motion_mm = 0.1, history = "rub" }, { motion_mm = 0.2 }]
z          = { force_N = -500.0, history = "press" }
rotation_x = "fixed"
rotation_y = { motion_rad = 0.01, history = "press" }
rotation_z = { spring_N_mm_per_rad = 50.0 }
centre_mm  = [0.0, 0.0, 50.0]

[support.stop]
body   = "stop"
x      = "fixed"
z      = { spring_N_per_mm = 1000.0, motion_mm = 0.02 }
axis_z = [0.0, 0.0, 2.0]
axis_x = [1.0, 1.0, 0.0]

[support.slope]
face   = "flat_side"
normal = { motion_mm = 0.1, history = "press" }

[load.squeeze]
face     = "flat_side"
parts    = [{ pressure_MPa = 5.0, history = "press" }, { traction_MPa = [0, 0, 1] }, { force_N = [10, 0, 0] }]

[load.weight]
body            = "flat"
force_N_per_mm3 = [0.0, 0.0, -7.7e-5]

[history]
press = [[0.0, 0.0], [1.0, 1.0]]
rub   = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]

[[step]]
name = "press"
play = ["press"]
increments = 4

[[step]]
name = "rub"
play = ["rub"]
increments = 20
cycles = 3

[output]
frames = { every_increment = true }
probes = { edge = { body = "flat", at_mm = [5.0, 0.0, 0.0] } }
)";

/// A folder with the geometry that the example names.
class SolidFolder : public Folder {
 public:
  SolidFolder() { write("ball_on_flat.step", "ISO-10303-21;"); }
};

inline scene::SolidScene solid_scene(const std::string& text) {
  const SolidFolder folder;
  Folder::write("scene.toml", text);
  return scene::read_solid("scene.toml");
}

/// What reading this text says; empty when it is accepted.
inline std::string solid_refusal(const std::string& text) {
  try {
    solid_scene(text);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace reye::test
