#pragma once
#include <functional>
#include <string>

#include "sim/problem.hpp"

namespace reye::sim {

/// Who watches a run; every member may be empty. Exceptions thrown by a member end the run.
struct Observer {
  std::function<void(const Progress&)> progress;
  std::function<void(const IncrementRecord&)> increment;
  std::function<void(const Frame&)> frame;
  std::function<void(const RemeshRecord&)> remesh;
  std::function<void(const State&)> block;        ///< at each block end: where checkpoints are taken
  std::function<void(const std::string&)> log;
  std::function<bool()> interrupted;              ///< asked after each increment
};

/// Plays all steps from `state` on; `state` ends as the last accepted one. A failed solve or shape is a
/// summary with a reason, never an exception. `cache`: of `prepare`, if it was kept.
Summary run(const Problem& problem, State& state, const Observer& observer, Cache& cache);
Summary run(const Problem& problem, State& state, const Observer& observer);

}  // namespace reye::sim
