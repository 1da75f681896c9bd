#include "sim/march/watch_block.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "sim/measure/small_strain.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

/// Watches small strain that the trial accepted, since its error may grow as bodies wear.
void watch_chosen_strain(const Problem& problem, State& state, const solver::System& system, const Observer& observer) {
  const auto now = small_strain_error(problem, state, system);
  const double before = state.small_strain_error.value_or(0.0);
  if (!now || *now <= before) return;
  state.small_strain_error = now;
  if (*now <= small_strain_bound) return;
  const std::string text = base::formatted(
      "small strain was chosen, but its estimated error is %.2g %% at cycle %g: "
      "kinematics = \"finite\" is without it",
      100.0 * *now, state.cycle);
  warn(state, observer, {"strain", "", text, *now});
}

}  // namespace

double largest_plastic_strain(const State& state) {
  double largest = 0.0;
  for (const auto& interior : state.solution.interiors)
    for (const auto& point : interior.history) largest = std::max(largest, point.accumulated);
  return largest;
}

double mean_plastic_strain(const State& state) {
  double sum = 0.0, points = 0.0;
  for (const auto& interior : state.solution.interiors)
    for (const auto& point : interior.history) sum += point.accumulated, ++points;
  return points > 0.0 ? sum / points : 0.0;
}

void watch_tolerance(const scene::Step& step, State& state, const Observer& observer) {
  const double error = state.jump_error.value_or(0.0);
  if (error <= step.jump_tolerance) return;
  const std::string words = base::formatted(
      "at cycle %g the estimated error of the cycle jump is %.2g %%, above the tolerance of "
      "%.2g %%; a smaller jump.first or jump.most, or more increments a cycle, lower it",
      state.cycle, 100.0 * error, 100.0 * step.jump_tolerance);
  warn(state, observer, {"tolerance", "step " + step.name, words, error / step.jump_tolerance});
}

void watch_plastic_strain(const scene::Step& step, double before, double cycles, State& state,
                          const Observer& observer) {
  const double now = largest_plastic_strain(state), most_missing = (cycles - 1.0) * (now - before);
  if (most_missing <= 0.01 * now) return;
  const std::string words = base::formatted(
      "cycles that are jumped add no plastic strain, of which the run shows too little: up to cycle %g its largest "
      "value "
      "grew from %.3g to %.3g in cycles that stand for %.3g each; jump = 1 plays every cycle",
      state.cycle, before, now, cycles);
  warn(state, observer, {"plastic", "step " + step.name, words, most_missing / now});
}

std::string watch_strain(const Problem& problem, State& state, const solver::System& system, bool last,
                         const Observer& observer) {
  constexpr long first = 8, every = 8;
  if (state.step_blocks > first && state.step_blocks % every != 0 && !last) return {};
  watch_chosen_strain(problem, state, system, observer);
  return check_small_strain(problem, state, system, observer);
}

}  // namespace reye::sim
