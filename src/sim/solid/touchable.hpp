#pragma once
#include <vector>

#include "sim/solid/solid_problem.hpp"
#include "solver/solid/solid_newton.hpp"

/// Which nodes contact may touch: they alone are kept by the condensation.
namespace reye::sim {

/// Per body and node.
using Touchable = std::vector<std::vector<char>>;

/// Nodes of the contacts' facets that lie in their fine zones, or pass through them while a support turns their body,
/// and one ring beyond; of a contact without fine zone those nearer to the other side than the drawn distance and two
/// facets.
Touchable touchable_nodes(const SolidProblem& problem);

/// Nodes of all faces of contacts: touchable ones are among them.
Touchable contact_nodes(const SolidProblem& problem);

/// Adds rings of facets of the contacts' faces; false where there is nothing to add.
bool grow(const SolidProblem& problem, Touchable& touchable, int rings);

}  // namespace reye::sim
