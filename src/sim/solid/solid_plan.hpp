#pragma once
#include <string>
#include <vector>

#include "sim/solid/touchable.hpp"

namespace reye::sim {

/// Sizes of a problem whose condensation keeps so many nodes of all bodies.
SolidSize size_of(const SolidProblem& problem, int retained);

/// Increments of all steps and cycles.
double solid_increments(const SolidProblem& problem);

/// What a run would take, as `reye plan` prints it.
struct SolidPlan {
  SolidSize size;
  double increments = 0.0;
  std::vector<std::string> lines;
  std::string refusal;  ///< why it cannot run here; empty: it can
};
SolidPlan solid_plan(const SolidProblem& problem);

}  // namespace reye::sim
