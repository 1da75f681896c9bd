#pragma once
#include "base/errors.hpp"
#include "sim/problem.hpp"

namespace reye::sim {

/// A linear body that is free to turn, but bonded to one that keeps its direction, keeps its own.
void keep_directions(Problem& problem);

/// Bonds whose sides, as drawn, do not lie on one another: nothing of them is opposite, or more than a fraction of a
/// facet apart.
std::vector<base::Issue> bond_issues(const Problem& problem, const solver::System& system);

}  // namespace reye::sim
