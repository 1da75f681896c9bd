#pragma once
#include "scene/scene.hpp"

namespace reye::sim {

/// Where the scene writes what a message is about ("contact pad", "step wear"): "scene.toml:16: "; empty where it is no
/// table of the scene.
std::string scene_line(const scene::Scene& scene, const std::string& about);

}  // namespace reye::sim
