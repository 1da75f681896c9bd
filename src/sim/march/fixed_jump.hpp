#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Cycles of the next block of a step with a fixed jump of `whole` cycles, `done` of which are played. A body that
/// yields shakes down in the first cycles, which no later one resembles: where one may, the first block is played in
/// parts, one cycle and then each as long as all before it, so that no cycle stands for more of them than the step has
/// had. Where the rest of that block, by the `flow` of the last cycle, would add less than a hundredth of all plastic
/// strain, it is played at once.
double next_fixed(const Problem& problem, const scene::Step& step, double whole, double done, double flow);
double next_fixed(const Problem& problem, const scene::Step& step, const State& state);  ///< where a run stands

/// The share of all plastic strain that has been added since it was `before` in the mean; all of it where points are
/// not those of before.
double flow_since(const State& state, double before, bool same_points);

/// Plays a block of as many cycles as the scene says. A block that wears and fails is repeated on a quarter of them,
/// down to one; the blocks after it keep the number that worked (State::block_cycles), with a warning that names it. A
/// block of one cycle that fails is a failure.
Outcome play_fixed(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& observer);

}  // namespace reye::sim
