#include "sim/solid/solid_watch_jump.hpp"

#include <utility>

#include "sim/march/jump_rule.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

void watch_jump(const SolidProblem& problem, SolidPlayer& player, SolidRunState& state, const scene::Step& step,
                double cycles, const SolidObserver& observer) {
  if (!last_to_jump(problem.scene.steps, step) || !(cycles > unjumped)) return;
  const auto removed = removed_volumes(state.block_wear), at_end = removed_volumes(state.solution.wear);
  const SolidSpan span{.step = &step, .jump = unjumped, .cycles = true, .last = true, .recorded = false};
  SolidObserver quiet;
  quiet.interrupted = observer.interrupted;
  const SolidOutcome cycle = player.play(state, span, quiet);
  if (player.has_equations() && cycle.state.points != state.points) {  // contact has outrun them
    state = player.brought_up(std::move(state));
    player.settle(state, step);
    return;
  }
  if (!cycle.failure.empty() || cycle.interrupted || !same_sizes(removed, at_end)) return;
  const double apart = worn_elsewhere(removed, at_end, removed_volumes(cycle.state.solution.wear));
  auto warning = uneven_jump(step, state.cycle, cycles, apart);
  if (!warning) return;
  const std::string text = in_words(*warning);
  if (warn(state.warnings, std::move(*warning)) && observer.log) observer.log("warning: " + text);
}

}  // namespace reye::sim
