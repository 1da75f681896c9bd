#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// What a run has still to solve, as far as its rules say.
struct Work {
  double blocks = 0.0;
  double cycles = 0.0;      ///< plays of a cycle, those of halves and for levelling included
  double increments = 0.0;  ///< of these and of load steps

  Work& operator+=(const Work& more);
};

/// The work after a block end, up to the cycle at which a limit would end the run, as its measure grows: exact for
/// load steps and fixed jumps that are not cut; under a tolerance the next blocks grow as they may, each to at most the
/// cycles played before it, or to the share of them that the last one has settled at.
Work work_left(const Problem& problem, const State& state);

}  // namespace reye::sim
