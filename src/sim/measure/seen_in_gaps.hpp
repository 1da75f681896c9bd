#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "solver/system.hpp"

namespace reye::sim {

/// Sets what contacts see in their gaps beside their own wear, in an increment that ends at progress `to`: that of the
/// others on their boundaries, and where the play is continued what it is expected to wear from there on; with what
/// thickness worn layers count.
void set_seen_in_gaps(solver::Controls& controls, const Problem& problem, const State& state,
                      const solver::System& system, const BlockSpan& span, double to);

}  // namespace reye::sim
