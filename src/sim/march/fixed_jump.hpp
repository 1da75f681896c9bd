#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Plays a block of as many cycles as the scene says. A block that wears and fails is repeated on a quarter of them,
/// down to one; the blocks after it keep the number that worked (State::block_cycles), with a warning that names it. A
/// block of one cycle that fails is a failure.
Outcome play_fixed(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& observer);

}  // namespace reye::sim
