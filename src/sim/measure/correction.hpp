#pragma once
#include "sim/measure/side_correction.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/two_step.hpp"

/// The correction of a block's wear, from playing it once as a whole and once in two halves.
namespace reye::sim {

/// A block that was played twice: its start, its end as a whole, and its contacts after the first of two halves.
struct Twice {
  const State& start;
  const State& once;
  const std::vector<contact::ContactState>& middle;
};

/// Per node of a side, from 0 to 1, how far the error of its wear is linear in the cycles of the block: 0 where an edge
/// of contact or of slip passed in the block or lies elsewhere in the two plays, then rising over three elements.
std::vector<double> trust(const mortar::Surface& surface, const std::vector<char>& passed);

/// Error of the end of a block that was played twice: per contact and side that wears, sum_j |V_j - V'_j| over sum_j
/// V_j, V the volumes removed since the start, and the difference of the largest depths over the largest depth; the
/// largest of all. The share `settled` of the correction by `extrapolate` is not counted.
double wear_difference(const solver::System& system, const Twice& twice, const State& halves);

/// Error of the end of a block that the two-step formula has continued from `start`: as `wear_difference`, by what two
/// halves of it would differ from it as a whole.
/// Empty where the formula does not serve (`ContinuedSide`).
std::optional<double> continued_difference(const solver::System& system, const State& start, const TwoStep& formula,
                                           const State& end);

/// Whether no contact that slipped in a block has a node under pressure that did not; not either where none is under
/// pressure at its end, which does not show it.
bool slips_throughout(const State& start, const State& end);

/// Adds the difference between the two halves and the whole once more: with an error linear in the cycles, V + (V -
/// V_once) is of second order. Each node takes its share by `trust`; what remains of the sum goes to the nodes that are
/// not trusted, in proportion to their wear, so that volumes, work and energy are extrapolated alike and the ledger
/// stays exact: where load and path determine the sum, the middle gains what the edges lose. A contact where a node
/// would get material back that waits in no gap, stays as the halves left it.
void extrapolate(const solver::System& system, const Twice& twice, State& halves);

}  // namespace reye::sim
