#include "sim/solid/solid_state.hpp"

#include <algorithm>
#include <numeric>

#include "sim/measure/limits.hpp"

namespace reye::sim {

namespace {

constexpr double cycle_round_off = 1e-9;  ///< of the cycles of a step

bool ended_by_limit(const SolidProblem& problem, const SolidRunState& state) {
  const auto& limits = problem.scene.limits;
  return std::any_of(limits.begin(), limits.end(), [&](const auto& limit) {
    const auto now = state.limit_measure.find(limit.name);
    return limit.stop && now != state.limit_measure.end() && is_reached(limit, now->second);
  });
}

}  // namespace

SolidRunState initial_solid_state(const SolidProblem& problem) {
  SolidRunState state;
  state.meshes = state.born = drawn_meshes(problem);
  state.touchable = touchable_nodes(problem, state.meshes);
  for (const auto& [name, corners] : problem.scene.histories) state.factors[name] = 0.0;
  state.energy_last_cycle_mJ.assign(problem.contacts.size(), 0.0);
  state.widest_stick.resize(problem.contacts.size());
  return state;
}

double cycles_left(const scene::Step& step, const SolidRunState& state) { return step.cycles - state.step_cycles; }

bool is_over(const scene::Step& step, const SolidRunState& state) {
  return step.cycles > 0.0 ? cycles_left(step, state) <= cycle_round_off * step.cycles : state.step_blocks > 0;
}

bool at_end(const SolidProblem& problem, const SolidRunState& state) {
  const auto& steps = problem.scene.steps;
  const int last = static_cast<int>(steps.size()) - 1;
  return state.step > last || (state.step == last && is_over(steps.back(), state)) || ended_by_limit(problem, state);
}

double energy_of(const SolidRunState& state, std::size_t contact) {
  return state.solution.wear[contact].frictional_work;
}

double removed_volume(const SolidRunState& state) {
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  double volume = 0.0;
  for (const auto& wear : state.solution.wear) volume += sum(wear.removed_secondary) + sum(wear.removed_primary);
  return volume;
}

}  // namespace reye::sim
