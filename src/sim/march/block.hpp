#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Sets zero displacements and fresh contacts.
void begin_state(const Problem& problem, State& state, Cache& cache);

/// Counts in `start`, from which a block is to be played once more, what the play before has cost; its remeshes are
/// undone.
void keep_counts(State& start, const Counts& played);

/// Plays one block in full.
Outcome play_block(const Problem& problem, const State& state, Cache& cache, const BlockSpan& span,
                   const Observer& observer);

/// Completes a block after its increments: shape step, fresh meshes, renewed references.
Outcome end_block(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer);

/// Plays all increments of one block, with cut-backs.
Outcome play_increments(const Problem& problem, State state, Cache& cache, const BlockSpan& span,
                        const Observer& observer);

}  // namespace reye::sim
