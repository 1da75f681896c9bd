#include "sim/solid/solid_watch_jump.hpp"

#include <optional>
#include <utility>

#include "sim/march/jump_rule.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

void watch_jump(const SolidProblem& problem, SolidPlayer& player, SolidRunState& state, const scene::Step& step,
                double cycles, const SolidObserver& observer) {
  if (!last_to_jump(problem.scene.steps, step) || !(cycles > unjumped)) return;
  const auto worn_in = [&](double jump) -> std::optional<Volumes> {
    const SolidSpan span{.step = &step, .jump = jump, .cycles = true, .last = true, .recorded = false};
    SolidObserver quiet;
    quiet.interrupted = observer.interrupted;
    for (int turn = 0; turn < 2; ++turn) {
      const SolidOutcome play = player.play(state, span, quiet);
      if (player.has_equations() && play.state.points != state.points) {  // contact has outrun them
        state = player.brought_up(std::move(state));
        player.settle(state, step);
        continue;
      }
      if (!play.failure.empty() || play.interrupted) return std::nullopt;
      return worn_between(removed_volumes(state.solution.wear), removed_volumes(play.state.solution.wear));
    }
    return std::nullopt;
  };
  const auto cycle = worn_in(unjumped);
  if (!cycle) return;
  const auto removed = removed_volumes(state.block_wear), at_end = removed_volumes(state.solution.wear);
  const auto block = removed == at_end ? worn_in(cycles) : worn_between(removed, at_end);  // equal on a fresh mesh
  if (!block || !same_sizes(*block, *cycle)) return;
  auto warning = uneven_jump(step, state.cycle, cycles, worn_elsewhere(*block, *cycle));
  if (!warning) return;
  const std::string text = in_words(*warning);
  if (warn(state.warnings, std::move(*warning)) && observer.log) observer.log("warning: " + text);
}

}  // namespace reye::sim
