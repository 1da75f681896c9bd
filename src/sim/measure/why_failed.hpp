#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "solver/report.hpp"

namespace reye::sim {

/// A failed attempt: an increment of a block, or the equilibrium on its new shape.
struct Attempt {
  const scene::Step* step = nullptr;
  double jump = 1.0;  ///< cycles of the block
  solver::Failure failure = solver::Failure::no_convergence;
  std::string reason;  ///< of the solver
};

/// The cause of a failure in the words of the scene, with what to change: a load, a wear or a gap out of all
/// proportion, a worn body, a contact of one element, a body that has come away. It is judged by the last good state;
/// if none of these applies, it is the solver's reason.
std::string why_failed(const Problem& problem, const State& last, const Attempt& attempt, const solver::System& system);

}  // namespace reye::sim
