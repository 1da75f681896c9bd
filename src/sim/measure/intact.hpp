#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Whether a state that was read from a file can be one of this problem: whole meshes, sizes that belong together,
/// indices within their counts, finite numbers. Throws std::runtime_error with the contradiction. The equations that it
/// sets up on the state's shapes stay in the cache.
void check_state(const Problem& problem, const State& state, Cache& cache);

}  // namespace reye::sim
