#pragma once
#include "base/errors.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"

/// Errors that can be known before a run, and what deserves a warning.
namespace reye::sim {

/// Issues of supports that contradict each other in one place; supports that lose a corner become warnings.
std::vector<base::Issue> support_conflicts(Problem& problem);

/// Warns of steps whose cycles do not count, play nothing or are too coarse in time, and of limits without cycles.
void warn_of_steps(const scene::Scene& scene, std::vector<Warning>& warnings);

}  // namespace reye::sim
