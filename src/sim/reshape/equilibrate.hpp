#pragma once
#include <string>
#include <vector>

#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

/// Equilibrium on a shape that has changed.
namespace reye::sim {

/// Tractions of the secondary nodes as forces, times A_j, before the shape moves.
struct HeldTraction {
  std::vector<double> normal, tangential;
};

std::vector<HeldTraction> held_tractions(const solver::System& system, const State& state);

/// Brings the state to equilibrium on its shapes with the shear as given load, whose nodal resultant is kept; where the
/// span is continued, on what its play is expected to wear from progress `ahead` on, too, and nodes that slide have the
/// shear that friction allows. Returns a failure in words.
std::string re_equilibrate(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                           const std::vector<HeldTraction>& held, double ahead = 0.0);

/// Brings the state to equilibrium with all tractions held: springs in the gaps are too soft to change a pressure.
/// Returns a failure in words.
std::string equilibrate_on_springs(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                                   const std::vector<HeldTraction>& held);

}  // namespace reye::sim
