#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// The bodies of a scene with their meshes, and supports, loads, contacts and bonds placed on them; checked. Plays
/// nothing: a body that leaves its kinematics to the run is small-strained, and there is no plan. `cache` takes the
/// equations that were set up for the checks. Throws base::InputError at the keys concerned, base::MeshError,
/// base::SolveError.
Problem place(const scene::Scene& scene, Cache& cache);

/// The material and the kinematics of a deformable body, as its scene says; small strain where that is not decided yet.
/// LinearElastic, which is not a law of finite strain, becomes Hencky's law with its constants there.
void take_material(const scene::Scene& scene, body::BodyInput& input);

}  // namespace reye::sim
