#pragma once
#include <functional>
#include <string>

#include "sim/solid/solid_records.hpp"
#include "sim/solid/solid_state.hpp"

namespace reye::sim {

/// Callbacks that observe a run of solids; every member may be empty.
struct SolidObserver {
  std::function<void(const Progress&)> progress;
  std::function<void(const SolidIncrement&)> increment;
  std::function<void(const SolidFrame&)> frame;
  std::function<void(const SolidRemeshRecord&)> remesh;
  /// At the end of each block, and of each increment of a block that is played once, where checkpoints are taken.
  std::function<void(const SolidRunState&)> state;
  std::function<void(const std::string&)> log;
  std::function<bool()> interrupted;  ///< asked after each increment
};

}  // namespace reye::sim
