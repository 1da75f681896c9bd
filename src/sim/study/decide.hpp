#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// The problem as `place` gives it, with its plan and with the kinematics that only a trial can decide.
Problem decide(const scene::Scene& scene, Cache& cache);

}  // namespace reye::sim
