#include "sim/problem/ending.hpp"

#include <algorithm>

namespace reye::sim {

double remaining(const scene::Step& step, const State& state) { return step.cycles - state.step_cycles; }

bool step_over(const scene::Step& step, const State& state) {
  return step.cycles > 0.0 ? remaining(step, state) <= 1e-9 * step.cycles : state.step_blocks > 0;
}

bool at_end(const Problem& problem, const State& state) {
  const auto& [steps, limits] = std::tie(problem.scene.steps, problem.scene.limits);
  if (std::any_of(limits.begin(), limits.end(),
                  [&](const auto& limit) { return limit.stop && state.life_cycles.contains(limit.name); }))
    return true;
  const auto last = static_cast<int>(steps.size()) - 1;
  return state.step > last || (state.step == last && step_over(steps.back(), state));
}

}  // namespace reye::sim
