#include "sim/solid/solid_state.hpp"

#include <algorithm>
#include <cmath>

namespace reye::sim {

SolidRunState initial_solid_state(const SolidProblem& problem) {
  SolidRunState state;
  state.touchable = touchable_nodes(problem);
  for (const auto& [name, corners] : problem.scene.histories) state.factors[name] = 0.0;
  state.energy_mJ.assign(problem.contacts.size(), 0.0);
  state.energy_before_cycle_mJ = state.energy_last_cycle_mJ = state.energy_mJ;
  return state;
}

int plays_of(const scene::Step& step) { return std::max(1, static_cast<int>(std::lround(step.cycles))); }

bool at_end(const SolidProblem& problem, const SolidRunState& state) {
  const auto& steps = problem.scene.steps;
  const int last = static_cast<int>(steps.size()) - 1;
  return state.step > last || (state.step == last && state.step_plays >= plays_of(steps.back()));
}

}  // namespace reye::sim
