#pragma once
#include "solver/increment.hpp"

namespace reye::solver {

/// Semi-smooth Newton (primal-dual active set) for one increment. Nonlinear bodies are treated as linear ones that are
/// renewed: contact settles on their linearisation, then they are linearised again in that state, until both are met.
/// Each renewal is a Newton step of the whole system, with the active set of its end. Work space is kept between calls;
/// so are the reach and the last increment, which steer but do not decide the result: `reset` forgets them.
class Newton {
 public:
  // Compiled once: every file that holds one would else compile them.
  Newton();
  Newton(const Newton&);
  Newton(Newton&&) noexcept;
  Newton& operator=(const Newton&);
  Newton& operator=(Newton&&) noexcept;
  ~Newton();

  explicit Newton(NewtonOptions options);

  /// From the accepted state `before` to equilibrium under `controls`. A failure is a result with a reason.
  SolveResult solve(const System& system, const SolverState& before, const Controls& controls);

  /// To be called where the system changes, and at every block start.
  void reset();

 private:
  NewtonOptions options_;
  Increment increment_;
};

}  // namespace reye::solver
