#pragma once
#include <vector>

#include "base/issue.hpp"
#include "sim/solid/solid_problem.hpp"

namespace reye::sim {

/// What contacts of solids cannot do, with the keys of the scene: wear on the linear dual basis of curved facets, faces
/// that two contacts wear, and friction that slides across a plane of symmetry.
std::vector<base::Issue> refused_contacts(const SolidProblem& problem);

}  // namespace reye::sim
