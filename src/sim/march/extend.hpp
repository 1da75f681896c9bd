#pragma once
#include <set>

#include "base/errors.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Converts the state of a run for other limits and other cycles of the last step: records of limits that were removed
/// or changed (`limits`, by name) are deleted, and the new ones are measured. Returns the issues: fewer cycles than
/// played, under `cycles_key`, or limits that were passed. Checks the state as `check_state` does, with its exceptions.
std::vector<base::Issue> extend(const Problem& problem, const std::set<std::string>& limits,
                                const std::string& cycles_key, State& state, Cache& cache);

}  // namespace reye::sim
