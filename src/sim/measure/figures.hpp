#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"

/// Rows of the history.
namespace reye::sim {

/// A row of the history with the wear until now alone: largest depths and energy.
IncrementRecord wear_of(const Problem& problem, const solver::System& system, const State& state);

/// Adds to a row a share of the wear between two rows.
void add_wear(IncrementRecord& row, double share, const IncrementRecord& before, const IncrementRecord& after);

/// A row of the history without its step and cycle: wear, peak pressure and the forces of supports.
IncrementRecord figures_of(const Problem& problem, const State& state, const solver::System& system,
                           const solver::Controls& controls);

}  // namespace reye::sim
