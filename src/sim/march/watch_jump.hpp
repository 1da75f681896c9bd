#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// At the end of the last step that jumps by blocks of one size: plays a cycle by itself from there, warns where it
/// wears other places than the block before it did, and drops it; no count has it. `removed`: volumes at the start of
/// that block, of `cycles`; empty where it ended on a fresh mesh, on which a block as long is then played and dropped
/// in its place. Blocks under a tolerance see in every increment the wear of their end, and need none.
void watch_jump(const Problem& problem, State& state, Cache& cache, const scene::Step& step, const Volumes& removed,
                double cycles, const Observer& observer);

}  // namespace reye::sim
