#pragma once
#include "sim/problem/problem.hpp"
#include "solver/system.hpp"

namespace reye::sim {

/// Says what each body and contact is, what is skipped and why, with dofs.
Plan make_plan(const Problem& problem, const solver::System& system);

}  // namespace reye::sim
