#include "sim/march/watch_jump.hpp"

#include <optional>
#include <utility>

#include "sim/march/block.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

void watch_jump(const Problem& problem, State& state, Cache& cache, const scene::Step& step, const Volumes& removed,
                double cycles, const Observer& observer) {
  if (!last_to_jump(problem.scene.steps, step) || !(cycles > unjumped)) return;
  const auto at_end = removed_volumes(state.solution.contacts);
  const auto worn_in = [&](double jump) -> std::optional<Volumes> {
    BlockSpan span;
    span.step = &step;
    span.jump = jump;
    span.cycles = true;
    span.remesh = false;
    Observer quiet;
    quiet.interrupted = observer.interrupted;
    const Outcome play = play_increments(problem, state, cache, span, quiet);
    if (!play.failure.empty() || play.interrupted) return std::nullopt;
    return worn_between(at_end, removed_volumes(play.state.solution.contacts));
  };
  const auto cycle = worn_in(unjumped);
  if (!cycle) return;
  const auto block = same_sizes(removed, at_end) ? worn_between(removed, at_end) : worn_in(cycles);
  if (!block) return;
  if (auto warning = uneven_jump(step, state.cycle, cycles, worn_elsewhere(*block, *cycle)))
    warn(state, observer, std::move(*warning));
}

}  // namespace reye::sim
