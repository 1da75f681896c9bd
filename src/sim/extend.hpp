#pragma once
#include <set>

#include "base/errors.hpp"
#include "sim/problem.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// Makes the state of a run that of one with other limits and other cycles of the last step: what it knew of limits
/// that are no more, or are others (`limits`, by name), goes, and where it stands with those is measured. Returns what
/// is against it: fewer cycles than it has played, under `cycles_key`, or limits that it has passed. Looks at the state
/// as `check_state` does, and throws what that throws.
std::vector<base::Issue> extend(const Problem& problem, const std::set<std::string>& limits,
                                const std::string& cycles_key, State& state, Cache& cache);

}  // namespace reye::sim
