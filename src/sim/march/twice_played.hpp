#pragma once
#include <map>
#include <string>
#include <vector>

#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Both ends of a block, before its shape step.
struct TwicePlayed {
  State once, halves;
  std::vector<contact::ContactState> half_way;
  std::map<std::string, double> middle;  ///< measures of the limits after the first half
  std::string failure;
  bool interrupted = false;
  bool remesh_due = false;  ///< a trigger fired after the first half, and was put off
  Counts counts;
};

/// Plays a block at once and in two halves; `coarse` and `fine` observe these plays.
TwicePlayed play_twice(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& coarse,
                       const Observer& fine);

}  // namespace reye::sim
