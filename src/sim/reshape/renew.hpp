#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Bodies whose elements deformation has made poor: the current shape becomes X, remeshed; Gauss points keep F0 and
/// plastic state, contacts their tractions; then re-equilibration with the shear as history. It is postponed while wear
/// waits in the gap. False: nothing was done, for lack of a reason or because it failed, which the log reports.
bool renew_references(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                      const Observer& observer);

}  // namespace reye::sim
