#pragma once
#include <optional>

#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"
#include "sim/solid/solid_observer.hpp"

namespace reye::sim {

/// Runs a problem: `march`, and after it, where the scene asks for it, the error of its mesh. `cache`: that of
/// `prepare`, if it was kept.
Summary run(const Problem& problem, State& state, const Observer& observer, Cache& cache);
Summary run(const Problem& problem, State& state, const Observer& observer);

/// Runs a problem of solids, `run_solid`, and after it, where the scene asks for it, the error of its mesh.
SolidSummary run(const SolidProblem& problem, SolidRunState state, const SolidObserver& observer,
                 std::optional<SolidAssembly> assembly = {});

}  // namespace reye::sim
