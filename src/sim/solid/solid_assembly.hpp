#pragma once
#include "sim/solid/touchable.hpp"

namespace reye::sim {

/// The equations of a problem on the nodes that may touch.
struct SolidAssembly {
  solver::SolidSystem system;
  contact::Columns columns;  ///< per body and node
  double seconds = 0.0;      ///< of CPU, for stiffness and factors
};

/// Condenses every body onto its touchable nodes. Throws base::SolveError.
SolidAssembly assemble(const SolidProblem& problem, const Touchable& touchable);

/// The state carried onto equations with more points: tractions stay with their nodes.
solver::SolidState carried(const SolidAssembly& from, const SolidAssembly& to, const solver::SolidState& state);

/// Whether a point presses whose facets were left out on one side: the contact has outrun its touchable nodes.
bool outrun(const solver::SolidSystem& system, const solver::SolidSolution& solution);

}  // namespace reye::sim
