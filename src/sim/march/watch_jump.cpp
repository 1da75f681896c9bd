#include "sim/march/watch_jump.hpp"

#include <utility>

#include "sim/march/block.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

void watch_jump(const Problem& problem, State& state, Cache& cache, const scene::Step& step, const Volumes& removed,
                double cycles, const Observer& observer) {
  const auto at_end = removed_volumes(state.solution.contacts);
  if (!last_to_jump(problem.scene.steps, step) || !(cycles > unjumped) || !same_sizes(removed, at_end)) return;
  BlockSpan span;
  span.step = &step;
  span.jump = unjumped;
  span.cycles = true;
  span.remesh = false;
  Observer quiet;
  quiet.interrupted = observer.interrupted;
  const Outcome cycle = play_increments(problem, state, cache, span, quiet);
  if (!cycle.failure.empty() || cycle.interrupted) return;
  const double apart = worn_elsewhere(removed, at_end, removed_volumes(cycle.state.solution.contacts));
  if (auto warning = uneven_jump(step, state.cycle, cycles, apart)) warn(state, observer, std::move(*warning));
}

}  // namespace reye::sim
