#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"

/// Tractions of bonds, whose largest tension and shear decide whether a coat comes off.   (README, 7)
namespace reye::sim {

/// Tractions from the table of a bond's secondary side. `cycle` is stored with its peaks.
BondTraction bond_traction(const contact::Setup& setup, const SurfaceRecord& surface, double cycle);

/// Tractions of every bond in the state.
std::vector<BondTraction> bond_tractions(const Problem& problem, const State& state, const solver::System& system,
                                         double cycle);

/// Keeps the largest in `State::bonds`, at the end of an accepted increment.
void watch_bonds(State& state, const std::vector<BondTraction>& now);

/// Summaries of the bonds at the end of a run.
std::vector<BondSummary> bond_summaries(const Problem& problem, const State& state, const solver::System& system);

}  // namespace reye::sim
