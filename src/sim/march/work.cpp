#include "sim/march/work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/march/fixed_jump.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/measure/limits.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/ending.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/two_step.hpp"

namespace reye::sim {

namespace {

/// Blocks under a tolerance that are played as a whole and in two halves, and those that continue one another.
struct Blocks {
  double plays, levelling;  ///< of one block, and more where its end is shown
  double growth;            ///< of a block over the one before it, at most
};
constexpr Blocks in_halves{3.0, 4.0, most_growth}, continued{1.0, 1.0, usual_ratio};
constexpr long telling_blocks = 3;  ///< blocks after which the length of the next one says something

/// Where a run stands in its cycles.
struct Place {
  double cycle = 0.0;                                    ///< of the run
  double done = 0.0;                                     ///< of the step
  double jump = 0.0;                                     ///< cycles of the next block under a tolerance
  double share = 1.0;                                    ///< of the cycles before it that a block has at most
  double end = std::numeric_limits<double>::infinity();  ///< cycle at which a limit may end the run
};

/// The cycle at which the first limit that ends the run is reached. A depth grows with the cycles to the power of 2/3
/// to 1, from a line contact to a flat one: between them.
double end_by_limits(const scene::Scene& scene, const State& state) {
  double end = std::numeric_limits<double>::infinity();
  for (const auto& limit : scene.limits) {
    const auto measure = state.limit_measure.find(limit.name);
    if (limit.stop && measure != state.limit_measure.end() && measure->second > 0.0)
      end = std::min(end, state.cycle * std::pow(std::max(1.0, bound_of(limit) / measure->second), 1.25));
  }
  return end;
}

/// Blocks of a fixed jump of `whole` cycles from `done` cycles of a step on; `next`: cycles of one after so many.
template <class Next>
Work fixed_blocks(double until, double done, double whole, const Next& next, double increments) {
  double blocks = 0.0;
  for (; done < std::min(until, whole) * (1.0 - 1e-9); ++blocks) done += next(done);
  if (until > done) blocks += std::ceil((until - done) / whole - 1e-9);
  return {blocks, blocks, blocks * increments};
}

Work controlled_blocks(const scene::FrameRules& frames, const scene::Step& step, const Blocks& blocks, Place& at,
                       double until, double increments) {
  Work work;
  while (at.done < until * (1.0 - 1e-9)) {
    const double left = until - at.done;
    const double cycles =
        std::min({at.jump, step.jump_most, left < 2.0 * at.jump && left > at.jump ? 0.5 * left : left});
    const bool last = cycles >= left * (1.0 - 1e-9);
    const bool levelled = frame_due(frames, {.cycle_before = at.cycle,
                                             .cycle = at.cycle + cycles,
                                             .number = static_cast<long>(work.blocks) + 1,
                                             .last = last,
                                             .share_before = at.done / step.cycles,
                                             .share = (at.done + cycles) / step.cycles});
    const Blocks& way = at.done > 0.0 ? blocks : in_halves;
    const double plays = way.plays + (levelled ? way.levelling : 0.0);
    work += {1.0, plays, plays * increments};
    at.done += cycles;
    at.cycle += cycles;
    at.jump = std::max(at.jump, std::min(blocks.growth * at.jump, at.share * at.cycle));
  }
  return work;
}

}  // namespace

Work& Work::operator+=(const Work& more) {
  blocks += more.blocks;
  cycles += more.cycles;
  increments += more.increments;
  return *this;
}

Work work_left(const Problem& problem, const State& state) {
  const scene::Scene& scene = problem.scene;
  Place at{state.cycle, state.step_cycles, state.jump};
  if (state.counts.blocks > telling_blocks && state.cycle > 0.0 && state.jump > 0.0)
    at.share = std::clamp(state.jump / state.cycle, 0.02, 1.0);
  at.end = end_by_limits(scene, state);
  Work work;
  for (auto s = static_cast<std::size_t>(state.step); s < scene.steps.size() && at.cycle < at.end; ++s) {
    const scene::Step& step = scene.steps[s];
    const bool present = static_cast<int>(s) == state.step;
    if (present && step_over(step, state)) continue;
    const auto increments = static_cast<double>(increment_ends(scene, step).size());
    const double until = std::min(step.cycles, at.done + at.end - at.cycle);  // of the step
    if (step.cycles == 0.0) {
      work += {1.0, 0.0, increments};
    } else if (under_tolerance(step)) {
      if (at.jump == 0.0) at.jump = step.jump;
      const auto& blocks = may_continue(problem.contacts) ? continued : in_halves;
      work += controlled_blocks(scene.output.frames, step, blocks, at, until, increments);
    } else {
      const double whole = present && state.block_cycles > 0.0 ? state.block_cycles : step.jump;
      const auto next = [&](double done) { return next_fixed(problem, step, whole, done, present ? state.flow : 1.0); };
      work += fixed_blocks(until, at.done, whole, next, increments);
      at.cycle += until - at.done;
    }
    at.done = 0.0;
  }
  return work;
}

}  // namespace reye::sim
