#pragma once
#include <vector>

#include "body/solid/solid_input.hpp"
#include "scene/solid/solid_scene.hpp"

namespace reye::sim {

/// Supports that turn a body far whose direction another support keeps: its rotation is taken as linear, and at an
/// angle theta stretches by theta^2 / 2. And steps whose rotations would take more increments than any run plays.
std::vector<base::Issue> turn_issues(const scene::SolidScene& scene, const std::vector<body::SolidInput>& inputs);

}  // namespace reye::sim
