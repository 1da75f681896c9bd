#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"
#include "sim/reshape/equilibrate.hpp"

namespace reye::sim {

/// The result of carrying a gap [mm].
struct CarriedGap {
  double moved_mm = 0.0;  ///< farthest that a node was moved
  double left_mm = 0.0;   ///< largest gap under a pressure that no worn node could close
  std::string failure;    ///< why no node was moved; empty otherwise
};

/// Equilibrium after a shape step or a remesh that carries the gap of worn contacts: worn nodes of `next` move until
/// the pressures in `held` are in equilibrium on the new shapes, and every body keeps its content. The pressure of a
/// conforming contact depends on gaps far smaller than a moved or redrawn outline preserves. Returns a failure of the
/// equilibrium in words. (README, 5)
std::string equilibrate_with_gap(const Problem& problem, State& next, Cache& cache, const BlockSpan& span,
                                 const std::vector<HeldTraction>& held, CarriedGap& gap);

}  // namespace reye::sim
