#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// The bodies of a scene with their meshes, and supports, loads, contacts and bonds placed on them; checked. Plays
/// nothing: a body that leaves its kinematics to the run is small-strained, and there is no plan. `cache` takes the
/// equations that were set up for the checks. Throws base::InputError at the keys concerned, base::MeshError,
/// base::SolveError.
Problem place(const scene::Scene& scene, Cache& cache);

}  // namespace reye::sim
