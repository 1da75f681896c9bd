#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// The end of a block of `cycles` under a tolerance on its new shape, levelled where the span says so, and after a
/// block that was played in halves where a body is to be remeshed, for which pressures must be those of the shape.
/// Levelling comes after the shape step, since no cycle has worn a corrected layer. The last block of a step leaves
/// remeshing to the next step.
Outcome shaped(const Problem& problem, State state, Cache& cache, BlockSpan span, double cycles,
               const Observer& observer);

}  // namespace reye::sim
