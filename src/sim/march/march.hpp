#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Plays all steps from `state` on; `state` ends as the last accepted one. A failed solve or shape is a summary with a
/// reason, never an exception. Times are left to the caller.
Summary march(const Problem& problem, State& state, const Observer& observer, Cache& cache);

}  // namespace reye::sim
