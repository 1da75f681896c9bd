#pragma once
#include "sim/solid/solid_observer.hpp"
#include "sim/solid/solid_problem.hpp"

namespace reye::sim {

/// Plays all steps. A failed solve is a result with its reason; bad input throws base::InputError.
SolidSummary run_solid(const SolidProblem& problem, const SolidObserver& observer);

}  // namespace reye::sim
