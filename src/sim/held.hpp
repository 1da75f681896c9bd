#pragma once
#include "base/errors.hpp"
#include "sim/problem.hpp"

namespace reye::sim {

/// Rigid motions that nothing holds: of a body by itself, where no load, no friction and no contacts that touch on
/// either side stand for a support, and of bodies in contact together, where only a support does.
std::vector<base::Issue> unheld_issues(const Problem& problem);

}  // namespace reye::sim
