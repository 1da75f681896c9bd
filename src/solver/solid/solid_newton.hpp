#pragma once
#include "solver/solid/increment_state.hpp"

namespace reye::solver {

struct SolidOptions {
  int max_newton = 30;
  double tolerance = 1e-9;  ///< of the largest traction
  /// Of the sum of forces, for bodies that are free to move. With friction, whose iterations cost more, ten times this
  /// is enough.
  double balance_tolerance = 1e-12;
};

/// One increment from `old`, one start after another until one converges.
SolidSolution solve_increment(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                              const SolidOptions& options);

}  // namespace reye::solver
