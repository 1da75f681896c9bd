#pragma once
#include <vector>

#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/remesh.hpp"
#include "sim/span.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// Shape evolution of all worn bodies, fresh meshes where a trigger, or `asked` (per body, or none), wants them, then
/// re-equilibration with the shear as history.
Outcome evolve_shape(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer,
                     const std::vector<RemeshReason>& asked = {});

/// Fresh meshes where asked for and re-equilibration; the state before it where that fails.
Outcome settle(const Problem& problem, State state, Change change, Cache& cache, const BlockSpan& span,
               const Observer& observer);

}  // namespace reye::sim
