#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// The end of steps and runs.
namespace reye::sim {

/// Cycles still to be played in a step.
double remaining(const scene::Step& step, const State& state);

bool step_over(const scene::Step& step, const State& state);

/// Whether the run ends with this state: its last step is over, or a limit that ends it has been reached.
bool at_end(const Problem& problem, const State& state);

}  // namespace reye::sim
