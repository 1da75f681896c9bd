#pragma once
#include "sim/solid/solid_observer.hpp"
#include "sim/solid/solid_problem.hpp"
#include "sim/solid/solid_state.hpp"

namespace reye::sim {

/// After a block that wears, before its shape moves: warns of each contact that forces alone drive where the stick zone
/// has receded by more than an element at either side, or has so few elements that its edge leaves the depth open. The
/// width of a zone is that of a disc of its area, in an elongated contact its share of the smaller width.
void warn_of_stick_edge(const SolidProblem& problem, const solver::SolidSystem& system, SolidRunState& state,
                        const SolidObserver& observer);

}  // namespace reye::sim
