#pragma once
#include "base/errors.hpp"
#include "sim/problem/problem.hpp"

namespace reye::sim {

/// Issues of rigid motions that nothing holds: of a single body, where neither load nor friction nor touching contacts
/// on either side replace a support, and of bodies in contact together, where only a support counts.
std::vector<base::Issue> unheld_issues(const Problem& problem);

}  // namespace reye::sim
