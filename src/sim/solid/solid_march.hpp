#pragma once
#include <functional>

#include "sim/solid/solid_measure.hpp"

namespace reye::sim {

/// Callbacks that observe a run of solids; every member may be empty.
struct SolidObserver {
  std::function<void(const Progress&)> progress;
  std::function<void(const SolidIncrement&)> increment;
  std::function<void(const SolidFrame&)> frame;
  std::function<void(const std::string&)> log;
  std::function<bool()> interrupted;  ///< asked after each increment
};

/// Plays all steps. A failed solve is a result with its reason; bad input throws base::InputError.
SolidSummary run_solid(const SolidProblem& problem, const SolidObserver& observer);

}  // namespace reye::sim
