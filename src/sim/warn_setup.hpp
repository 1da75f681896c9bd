#pragma once
#include "base/errors.hpp"
#include "sim/problem.hpp"
#include "sim/records.hpp"

/// Errors that can be known before a run, and what deserves a warning.
namespace reye::sim {

/// Supports that ask different things of one place: those that are refused, and, as warnings, those that lose a corner.
std::vector<base::Issue> support_conflicts(Problem& problem);

/// Steps whose cycles do not count, play nothing or are too coarse in time; limits without cycles.
void warn_of_steps(const scene::Scene& scene, std::vector<Warning>& warnings);

}  // namespace reye::sim
