#pragma once
#include <optional>

#include "sim/solid/solid_observer.hpp"

namespace reye::sim {

/// Plays all steps from this state. A failed solve is a result with its reason; bad input throws base::InputError.
/// `assembly`: the equations of the state, where its first increments are solved (`check_state`).
SolidSummary run_solid(const SolidProblem& problem, SolidRunState state, const SolidObserver& observer,
                       std::optional<SolidAssembly> assembly = {});

/// Plays all steps from the start.
SolidSummary run_solid(const SolidProblem& problem, const SolidObserver& observer);

}  // namespace reye::sim
