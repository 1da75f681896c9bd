#pragma once
#include "base/errors.hpp"
#include "sim/problem/problem.hpp"
#include "solver/system.hpp"

namespace reye::sim {

/// Marks bodies that keep their direction because they are bonded to one that does, although they are free to turn.
void keep_directions(Problem& problem);

/// Issues of bonds whose sides, as drawn, do not lie on one another: no facets are opposite, or they are more than a
/// fraction of a facet apart.
std::vector<base::Issue> bond_issues(const Problem& problem, const solver::System& system);

}  // namespace reye::sim
