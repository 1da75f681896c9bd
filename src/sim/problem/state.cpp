#include "sim/problem/state.hpp"

namespace reye::sim {

State initial_state(const Problem& problem) {
  State state;
  state.shapes = problem.shapes;
  for (const auto& [name, history] : problem.scene.histories) state.factors[name] = history.front()[1];
  state.small_strain_error = chosen_small_error(problem);
  return state;
}

State::State() = default;
State::State(const State&) = default;
State::State(State&&) noexcept = default;
State& State::operator=(const State&) = default;
State& State::operator=(State&&) noexcept = default;
State::~State() = default;

}  // namespace reye::sim
