#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// `place`, and what it takes a trial to know: the kinematics of bodies that leave it to the run. With the plan.
Problem decide(const scene::Scene& scene, Cache& cache);

}  // namespace reye::sim
