#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/problem.hpp"

/// Problems made from scene text.
namespace reye::test {

/// A block 2 x 1 above one of 4 x 1, `gap` between them.
inline std::string two_blocks(double gap) {
  return "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {1, " + std::to_string(gap) +
         ", 0, 2, 1};\nRectangle(2) = {0, -1, 0, 4, 1};\n"
         "Physical Surface(\"slider\") = {1};\nPhysical Surface(\"base\") = {2};\n"
         "Physical Curve(\"slider_bottom\") = {1};\nPhysical Curve(\"slider_top\") = {3};\n"
         "Physical Curve(\"base_bottom\") = {5};\nPhysical Curve(\"base_top\") = {7};\n";
}

inline const char* const block_scene = R"(geometry = ["blocks.geo"]
[material.steel]
E_MPa = 200e3
nu    = 0.3
[body.slider]
material = "steel"
mesh     = { far_size_mm = 0.5 }
[body.base]
material = "steel"
mesh     = { far_size_mm = 0.4 }
[contact.pad]
secondary = "slider_bottom"
primary   = ["base_top"]
friction  = 0.3
wear      = { law = "energy", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5 }
[support.holder]
edge     = "slider_top"
x        = { motion_mm = 0.01, history = "stroke" }
y        = { force_N_per_mm = -20.0, history = "press" }
rotation = "fixed"
[support.floor]
edge     = "base_bottom"
x        = "fixed"
y        = "fixed"
rotation = "fixed"
[history]
press  = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]
[[step]]
name = "press"
play = ["press"]
wear = false
[[step]]
name = "wear"
play = ["stroke"]
increments = 8
cycles = 40
jump = 10
)";

using Changes = std::vector<std::pair<std::string, std::string>>;

inline std::string with(std::string text, const Changes& changes) {
  for (const auto& [from, to] : changes) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("not in the scene: " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The problem of a scene with the two blocks beside it.
inline sim::Problem problem_of(const std::string& scene_text, double gap = 0.0) {
  return support::problem_from({{"blocks.geo", two_blocks(gap)}, {"scene.toml", scene_text}});
}

/// Frames of the start and the end of each step alone, so that no block is levelled on the way.
inline const char* const few_frames = "[output]\nframes.per_step = 0\n";

/// 40 000 cycles of the blocks: enough for the edges' pressure to be worn away.
inline sim::Problem worn_block(const std::string& jump, const std::string& more = "") {
  return problem_of(with(block_scene, {{"cycles = 40\njump = 10", "cycles = 40000\njump = " + jump}}) + more +
                    few_frames);
}

}  // namespace reye::test
