#pragma once
#include "solver/solid/increment_state.hpp"

namespace reye::solver {

struct SolidOptions {
  int max_newton = 30;
  double tolerance = 1e-10;          ///< of the largest traction
  double balance_tolerance = 1e-12;  ///< of the sum of forces, for bodies that are free to move
};

/// One increment from `old`, one start after another until one converges.
SolidSolution solve_increment(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                              const SolidOptions& options);

}  // namespace reye::solver
