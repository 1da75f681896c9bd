#pragma once
#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/records.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// Plays all steps from `state` on; `state` ends as the last accepted one. A failed solve or shape is a summary with a
/// reason, never an exception. Times are left to the caller.
Summary march(const Problem& problem, State& state, const Observer& observer, Cache& cache);

}  // namespace reye::sim
