#pragma once
#include "sim/block.hpp"

/// Blocks whose number of cycles is chosen by the error they make.
namespace reye::sim {

/// Cycles for the next block. Errors count relative to all that is worn: they go with the share that a block has in it,
/// between its first power (edges of the scar) and its second (the rest). `before`, `after`: what was worn at the ends
/// of the block whose error this is.
double next_jump(double jump, double error, double tolerance, double before, double after);

/// One block of at most `span.jump` cycles, played once as a whole and once in two halves with the same increments. Where
/// the two are too far apart for the step's tolerance, or one fails, fewer cycles are tried. The end is the extrapolated
/// one (`correction`); where it is shown, or a body was remeshed, two short cycles follow as part of the block.
/// `State::jump_error` becomes the larger of this block's error and of what is left of those before: their error stays,
/// what is worn grows.
Outcome play_controlled(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& observer);

}  // namespace reye::sim
