#pragma once
#include "sim/problem.hpp"

namespace reye::sim {

/// What led to no state: an increment, or the equilibrium on a new shape (no part of the step, nothing wears).
struct Attempt {
  const scene::Step* step = nullptr;
  double from = 0.0, to = 0.0;  ///< its part of the step, by progress
  double jump = 1.0;            ///< cycles that it stands for
  std::string reason;           ///< of the solver
};

/// The cause of a failure in the words of the scene, with what to change: a load, a wear or a gap out of all proportion, a worn
/// body, a contact of one element, a body that has come away. Seen from the last good state; where it is none of these, the
/// solver's reason.
std::string why_failed(const Problem& problem, const State& last, const Attempt& attempt, const solver::System& system);

}  // namespace reye::sim
