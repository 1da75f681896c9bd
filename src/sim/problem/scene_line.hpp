#pragma once
#include <functional>

#include "base/errors.hpp"
#include "scene/scene.hpp"

namespace reye::sim {

/// The line of the table that a message refers to ("contact pad", "step wear"), as "scene.toml:16: "; empty where it is
/// not a table of the scene.
std::string scene_line(const scene::Scene& scene, const std::string& about);

/// The key of a step, which has its number in the file: that of the distinct names before it, since a spectrum repeats
/// steps.
std::string key_of_step(const std::vector<scene::Step>& steps, const std::string& name);

/// Refusals of steps whose rotations would take more increments than any run plays, `increments` of each.
std::vector<base::Issue> endless_steps(const std::vector<scene::Step>& steps,
                                       const std::function<double(const scene::Step&)>& increments);

}  // namespace reye::sim
