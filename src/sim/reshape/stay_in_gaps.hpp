#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "solver/system.hpp"

namespace reye::sim {

/// Whether wear waits in a gap: the outlines have not moved by it yet.
bool wear_waits(const State& state);

/// Whether the wear of a block may stay in the gaps of its contacts, where Newton's equations have it anyway, in place
/// of moving the outlines at once: a moved outline costs its body a factorisation, its contacts their integrals on X
/// and an equilibrium. It may where
///
///     depth <= 0.01 of the shortest facet at the node, at every node of either side,
///
/// they may wait at all (`outlines_may_wait`), the end of the block is not shown, and no contact leaves its fine zone.
/// `state`: at the end of the block, before its shapes move.
bool may_stay_in_gaps(const Problem& problem, const State& state, const solver::System& system, const BlockSpan& span);

}  // namespace reye::sim
