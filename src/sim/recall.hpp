#pragma once
#include <map>
#include <utility>

#include "solver/system.hpp"

namespace reye::sim {

/// What each increment of a cycle led to when it was last played: from one block to the next that hardly changes, so
/// Newton starts there. Part of the state: where Newton starts decides the last digits.
struct Recall {
  int step = -1;                                              ///< that `played` is of
  std::map<std::pair<double, double>, solver::Guess> played;  ///< by progress, from and to
};

/// Of the increment of `step` between these progresses; null where it was not yet played on these meshes.
const solver::Guess* recalled(const Recall& recall, int step, double from, double to);

void note(Recall& recall, int step, double from, double to, const solver::SolverState& before,
          const solver::SolverState& after);

}  // namespace reye::sim
