#pragma once
#include "sim/block.hpp"

/// Blocks whose number of cycles is chosen by the error they make.
namespace reye::sim {

/// How far apart two ends of the same block are: per contact and side that wears, sum_j |V_j - V'_j| over sum_j V_j, V the
/// volumes removed since the start, and the difference of the largest depths over the largest depth; the largest of all.
double wear_difference(const solver::System& system, const State& once, const State& halves);

/// Adds what two halves have corrected once more: with the error of a block linear in its cycles, V + (V - V_once) is of
/// second order. Volumes, work and energy alike, so that the ledger stays; where a node would get material back, not at all.
void extrapolate(const State& once, State& halves);

/// Cycles for the next block. The error falls with them, between their first power (edges of the scar, which wear to
/// rest in every block) and their second (the rest), and counts relative to all that is worn: `growth` is its factor.
double next_jump(double jump, double error, double tolerance, double growth);

/// One block of at most `span.jump` cycles, played once as a whole and once in two halves. Where the two are too far apart
/// for the step's tolerance, or one fails, fewer cycles are tried. The end is the extrapolated one. `State::jump_error`
/// becomes the larger of this block's error and of what is left of those before: what they put wrong stays, what is worn
/// grows.
Outcome play_controlled(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& observer);

}  // namespace reye::sim
