#pragma once
#include <vector>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/reshape/equilibrate.hpp"

/// Quantities by which the equilibria before and after a remesh are compared.
namespace reye::sim {

/// Quantities by which the equilibria before and after a remesh are compared.
struct Balance {
  std::vector<Vec2> force;     ///< on the secondary side of each contact
  std::vector<double> energy;  ///< strain energy of each body [mJ per mm; mJ]
};

Balance balance_of(const Problem& problem, const State& state, const solver::System& system);

/// Root mean square over the contact of p - p0, over that of p0; p0 the pressures that were carried over.
double pressure_jump(const contact::Setup& setup, const contact::ContactState& state, const HeldTraction& carried);

/// Largest |p - p0| over the largest p0, without the outermost twentieth of the loaded nodes at either end of each run
/// of them.
double peak_jump(const contact::Setup& setup, const contact::ContactState& state, const HeldTraction& carried);

}  // namespace reye::sim
