#pragma once
#include "scene/scene.hpp"

namespace reye::sim {

/// The line of the table that a message refers to ("contact pad", "step wear"), as "scene.toml:16: "; empty where it is
/// not a table of the scene.
std::string scene_line(const scene::Scene& scene, const std::string& about);

}  // namespace reye::sim
