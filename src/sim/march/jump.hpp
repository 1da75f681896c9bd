#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

/// Blocks whose number of cycles is chosen by the error they make.
namespace reye::sim {

/// One block of at most `span.jump` cycles: it continues the one before (`play_continued`), or is played in halves
/// (`play_in_halves`) and, where its end is shown or a body is to be remeshed, levelled by short cycles that are part
/// of it. Where its error is too large for the step's tolerance, or it fails, fewer cycles are tried; at the start of a
/// step the first cycle is then played by itself, since it starts from a state unlike that of all later ones, with
/// bodies that yield from the outset; so is a cycle where fewer than `fewest_tried` are left to be played in halves.
/// `State::jump_error` becomes the larger of this block's error and the remainder of earlier ones, which fades as the
/// worn volume grows.
Outcome play_controlled(const Problem& problem, const State& state, Cache& cache, BlockSpan span,
                        const Observer& observer);

}  // namespace reye::sim
