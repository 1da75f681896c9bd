#pragma once
#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/records.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// What a user asks for: `march`, and after it, where the scene wants it, the error of its mesh. `cache`: of `prepare`,
/// if it was kept.
Summary run(const Problem& problem, State& state, const Observer& observer, Cache& cache);
Summary run(const Problem& problem, State& state, const Observer& observer);

}  // namespace reye::sim
