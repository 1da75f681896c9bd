#pragma once
#include <map>
#include <utility>
#include <vector>

#include "solver/system.hpp"

namespace reye::sim {

/// The end of each increment of a cycle when it was last played: it hardly changes from block to block, so Newton
/// starts there. It is part of the state, since the start of Newton decides the last digits.
struct Recall {
  int step = -1;                                              ///< that `played` is of
  std::map<std::pair<double, double>, solver::Guess> played;  ///< by progress, from and to
};

/// The guess for the increment of `step` between these progresses; null where it was not yet played on these meshes.
const solver::Guess* recalled(const Recall& recall, int step, double from, double to);

/// Per contact and secondary node: whether it touched in an increment of `step` when these were last played; empty
/// where none was played on these meshes.
std::vector<std::vector<char>> touched(const Recall& recall, int step);

void note(Recall& recall, int step, double from, double to, const solver::SolverState& before,
          const solver::SolverState& after);

}  // namespace reye::sim
