#pragma once
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Gives the fine zones of a scene that name no size (0) one that suits its accuracy, and reports what it did, a
/// sentence each; nothing where all have a size. A pilot, the whole run on few elements with its companion
/// (`mesh_error`), estimates an error e_0 of order p on n_0 elements per half width; n = n_0 (e_0 / e)^(1/p) then has
/// the error e wanted. The pilot has twice as many where too few touch or n > 4 n_0. Deterministic; `cache` counts the
/// time. Throws base::InputError at `accuracy`: no pilot gives an error, or n > 400.
std::vector<std::string> choose_sizes(scene::Scene& scene, Cache& cache);

}  // namespace reye::sim
