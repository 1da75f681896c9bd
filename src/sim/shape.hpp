#pragma once
#include <vector>

#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/remesh.hpp"
#include "sim/span.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// Moves the shapes of all worn bodies, remeshes where a trigger or `asked` (per body, or none) requires it, then finds
/// equilibrium with the shear as history.
Outcome evolve_shape(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer,
                     const std::vector<RemeshReason>& asked = {});

/// Remeshes where asked for and finds equilibrium; the state is unchanged where that fails.
Outcome settle(const Problem& problem, State state, Change change, Cache& cache, const BlockSpan& span,
               const Observer& observer);

}  // namespace reye::sim
