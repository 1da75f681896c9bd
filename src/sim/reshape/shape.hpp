#pragma once
#include <vector>

#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"
#include "sim/reshape/remesh.hpp"

namespace reye::sim {

/// Moves the shapes of all worn bodies, remeshes where a trigger or `asked` (per body, or none) requires it, then finds
/// equilibrium with the shear as history.
Outcome evolve_shape(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer,
                     const std::vector<RemeshReason>& asked = {});

/// The end of a block: its wear stays in the gaps while it may (`may_stay_in_gaps`; extrapolated wear is then brought
/// to equilibrium there), else the shapes move (`evolve_shape`).
Outcome wear_down(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer);

/// The state with its outlines moved by the wear that waits in the gaps; as it is where they cannot be moved, or none
/// waits.
State worn_by_what_waits(const Problem& problem, const State& state, Cache& cache, const scene::Step& step);

/// Remeshes where asked for and finds equilibrium; the state is unchanged where that fails.
Outcome settle(const Problem& problem, State state, Change change, Cache& cache, const BlockSpan& span,
               const Observer& observer);

}  // namespace reye::sim
