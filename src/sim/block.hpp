#pragma once
#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/span.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// Zero displacement, fresh contacts.
void begin_state(const Problem& problem, State& state, Cache& cache);

/// One block in full.
Outcome play_block(const Problem& problem, const State& state, Cache& cache, const BlockSpan& span,
                   const Observer& observer);

/// What follows the increments of a block: shape step, fresh meshes, renewed references.
Outcome end_block(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer);

/// All increments of one block, with cut-backs.
Outcome play_increments(const Problem& problem, State state, Cache& cache, const BlockSpan& span,
                        const Observer& observer);

}  // namespace reye::sim
