#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// The problem of a scene: reads geometry, finds names, meshes, checks, and decides values that the scene leaves open:
/// sizes of fine zones
/// (`choose_sizes`) and kinematics. Throws base::InputError with located lines. `cache`: takes the equations that were
/// set up for the checks; a run that is given it uses them.
Problem prepare(const scene::Scene& scene, Cache* cache = nullptr);

}  // namespace reye::sim
