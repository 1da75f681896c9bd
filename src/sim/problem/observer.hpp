#pragma once
#include <functional>
#include <string>

#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// Callbacks that observe a run; every member may be empty. Exceptions thrown by a member end the run.
struct Observer {
  std::function<void(const Progress&)> progress;
  std::function<void(const IncrementRecord&)> increment;
  std::function<void(const Frame&)> frame;
  std::function<void(const RemeshRecord&)> remesh;
  std::function<void(const State&)> block;  ///< at each block end: where checkpoints are taken
  std::function<void(const std::string&)> log;
  std::function<bool()> interrupted;  ///< asked after each increment
};

}  // namespace reye::sim
