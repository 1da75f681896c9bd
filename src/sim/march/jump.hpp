#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

/// Blocks whose number of cycles is chosen by the error they make.
namespace reye::sim {

/// One block of at most `span.jump` cycles, played once as a whole and once in two halves with the same increments.
/// Where the two are too far apart for the step's tolerance, or one fails, fewer cycles are tried; at the start of a
/// step the first cycle is then played by itself, since it starts from a state unlike that of all later ones; so is a
/// cycle where fewer than `fewest_tried` are left. The end
/// is the extrapolated one (`correction`); where it is shown, or a body is to be remeshed, short cycles that level it
/// follow as part of the block. `State::jump_error` becomes the larger of this block's error and the remainder of
/// earlier ones, which fades as the worn volume grows.
Outcome play_controlled(const Problem& problem, const State& state, Cache& cache, BlockSpan span,
                        const Observer& observer);

}  // namespace reye::sim
