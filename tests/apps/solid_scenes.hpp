#pragma once
#include "command.hpp"

/// A small scene of solids for the command.
namespace reye::test {

/// A cap of a ball R = 5 on a block, both 2 x 1 x 1: the half of y > 0.
inline const char* const rubbing_geo = R"(SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 5, 5};
Box(2) = {-1, 0, 0, 2, 1, 1};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Box(4) = {-1, 0, -1, 2, 1, 1};
Physical Volume("ball") = {3};
Physical Volume("flat") = {4};
)";

/// Four increments that press, three cycles of eight that rub in partial slip: half a second. Contact outruns its fine
/// zone, so that nodes are kept that were not at first.
inline const char* const rubbing = R"(title    = "Small rubbing ball"
analysis = "solid"
geometry = ["rubbing.geo"]
symmetry = ["ball_sy", "flat_sy"]

[material.steel]
E_MPa = 200e3
nu    = 0.3

[body.ball]
material = "steel"
order    = 1
mesh     = { far_size_mm = 0.5 }

[body.flat]
material = "steel"
order    = 1
mesh     = { far_size_mm = 0.5 }

[face]
ball_round  = { body = "ball", type = "sphere" }
ball_top    = { body = "ball", box_mm = [-1.1, -0.1, 0.99, 1.1, 1.1, 1.01] }
ball_sy     = { body = "ball", box_mm = [-1.1, -0.01, -0.1, 1.1, 0.01, 1.1] }
flat_top    = { body = "flat", box_mm = [-1.1, -0.1, -0.01, 1.1, 1.1, 0.01] }
flat_bottom = { body = "flat", box_mm = [-1.1, -0.1, -1.01, 1.1, 1.1, -0.99] }
flat_sy     = { body = "flat", box_mm = [-1.1, -0.01, -1.1, 1.1, 0.01, 0.1] }

[contact.pad]
secondary = "flat_top"
primary   = ["ball_round"]
friction  = 0.3
fine_zone = { centre_mm = [0.0, 0.0, 0.0], radius_mm = 0.06, size_mm = 0.04 }

[support.holder]
face       = "ball_top"
x          = { motion_mm = 0.002, history = "stroke" }
y          = "fixed"
z          = { force_N = -60.0, history = "press" }
rotation_x = "fixed"
rotation_y = "fixed"
rotation_z = "fixed"

[support.table]
face = "flat_bottom"
x    = "fixed"
y    = "fixed"
z    = "fixed"

[history]
press  = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]

[[step]]
name = "press"
play = ["press"]
increments = 4

[[step]]
name = "rub"
play = ["stroke"]
increments = 8
cycles = 3

[output]
checkpoint_s = 0
frames = { last_block = true }
probes = { foot = { body = "ball", at_mm = [0.0, 0.0, 0.5] } }
)";

/// The rubbing ball that wears with its flat, both remeshed after every second block.
inline std::string worn_rubbing() {
  return changed(rubbing, {{"friction  = 0.3\n",
                            "friction  = 0.3\nwear      = { law = \"energy\", secondary_mm3_per_J = 3e-2, "
                            "primary_mm3_per_J = 1e-2 }\n"},
                           {"increments = 4\n", "increments = 4\nwear = false\n"},
                           {"last_block = true", "at_remeshes = true"}}) +
         "\n[remesh]\nevery_blocks = 2\n";
}

/// A place with the rubbing ball in it.
struct WithRubbing : Place {
  WithRubbing() {
    write("rubbing.geo", rubbing_geo);
    scene({});
  }

  void scene(const Changes& changes) const { write("rubbing.toml", changed(rubbing, changes)); }

  Told run(const std::string& folder, bool restart = false) const {
    std::vector<std::string> words{"run", "rubbing.toml", "--out", folder, "--quiet"};
    if (restart) words.push_back("--restart");
    return reye(words);
  }

  /// Runs until the history has so many rows, then sends a signal; the run must not have ended by itself.
  Told interrupted(const std::string& folder, long rows, int signal, bool restart = false) const {
    std::vector<std::string> words{"run", "rubbing.toml", "--out", folder, "--quiet"};
    if (restart) words.push_back("--restart");
    auto run = start_reye(words);
    EXPECT_TRUE(run.signal_when(signal, [&] { return lines(*this / (folder + "/history.csv")) > rows; }));
    return run.wait();
  }
};

}  // namespace reye::test
