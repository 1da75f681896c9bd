#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// Clears the observations of the block before.
void begin_watch(const Problem& problem, State& state);

/// Observes contacts at the end of an accepted increment; `wear`: of a step that wears.
void watch_contacts(const Problem& problem, State& state, const solver::System& system, bool wear);

}  // namespace reye::sim
