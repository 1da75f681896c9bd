#pragma once
#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/records.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// Runs a problem: `march`, and after it, where the scene asks for it, the error of its mesh. `cache`: that of
/// `prepare`, if it was kept.
Summary run(const Problem& problem, State& state, const Observer& observer, Cache& cache);
Summary run(const Problem& problem, State& state, const Observer& observer);

}  // namespace reye::sim
