#pragma once
#include <functional>

#include "sim/solid/solid_measure.hpp"

namespace reye::sim {

/// Callbacks that observe a run of solids; every member may be empty.
struct SolidObserver {
  std::function<void(const Progress&)> progress;
  std::function<void(const SolidIncrement&)> increment;
  std::function<void(const SolidFrame&)> frame;
  std::function<void(const SolidRunState&)> state;  ///< at the end of each increment, where checkpoints are taken
  std::function<void(const std::string&)> log;
  std::function<bool()> interrupted;  ///< asked after each increment
};

/// Plays all steps from this state. A failed solve is a result with its reason; bad input throws base::InputError.
/// `assembly`: the equations of the state where its first increments are solved (`check_state`).
SolidSummary run_solid(const SolidProblem& problem, SolidRunState state, const SolidObserver& observer,
                       std::optional<SolidAssembly> assembly = {});

/// Plays all steps from the start.
SolidSummary run_solid(const SolidProblem& problem, const SolidObserver& observer);

}  // namespace reye::sim
