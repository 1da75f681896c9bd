#pragma once
#include <vector>

#include "sim/solid/solid_problem.hpp"
#include "solver/solid/solid_newton.hpp"

namespace reye::sim {

/// Looks at an increment that was solved for what a reader must know before trusting it: few elements across the
/// contact, pressure at the edge of a face, strains and turns beyond the linear theory. Of one kind about one thing the
/// most severe is kept.
void watch_solid(const SolidProblem& problem, const solver::SolidSystem& system, const solver::SolidSolution& solution,
                 std::vector<Warning>& warnings);

}  // namespace reye::sim
