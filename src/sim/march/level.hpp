#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Whether the pressures at the end of a play, whose wear waits in the gaps, are those of equilibrium on the shapes
/// that it leaves. They are not where an increment of so many cycles wears more than the bodies yield: its wear spreads
/// them. What that costs is counted in the state.
bool pressures_fit(const Problem& problem, State& state, Cache& cache, const BlockSpan& span);

/// The end of a block of `cycles` under a tolerance on its new shape, levelled where the span says so, and after a
/// block that was played in halves where a body is to be remeshed, for which pressures must be those of the shape.
/// Levelling comes after the shape step, since no cycle has worn a corrected layer. The last block of a step leaves
/// remeshing to the next step.
Outcome shaped(const Problem& problem, State state, Cache& cache, BlockSpan span, double cycles,
               const Observer& observer);

}  // namespace reye::sim
