#pragma once
#include <string>
#include <vector>

#include "sim/problem/problem.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// What a run will take, judged from a trial: its own beginning, played in memory.
struct Forecast {
  double blocks = 0.0, cycles = 0.0, increments = 0.0;  ///< of the whole run; cycles: plays of one
  double seconds = 0.0;                                 ///< of the whole run, at the pace of the trial
  double spread = 1.0;                                  ///< the time lies between seconds / spread and seconds x spread
  double memory_MB = 0.0;                               ///< the largest so far, meshing included
  double trial_seconds = 0.0;
  double trial_increments = 0.0;
  bool whole = false;     ///< the trial has played the run to its end
  std::string unknown{};  ///< why the time is not known; empty where it is
};

/// Plays the run for at least one increment and about `seconds`. `prepared_s`: what making the problem took, which the
/// run takes, too.
Forecast forecast(const Problem& problem, Cache& cache, double seconds, double prepared_s);

/// The forecast as sentences of the plan.
std::vector<std::string> in_words(const Forecast& forecast);

}  // namespace reye::sim
