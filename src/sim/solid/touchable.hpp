#pragma once
#include <vector>

#include "sim/solid/solid_problem.hpp"
#include "solver/solid/solid_newton.hpp"

/// Which nodes contact may touch: they alone are kept by the condensation.
namespace reye::sim {

/// The meshes of the bodies, as worn so far.
using SolidMeshes = std::vector<std::shared_ptr<const mesh::SolidMesh>>;

/// The meshes as they are drawn.
SolidMeshes drawn_meshes(const SolidProblem& problem);

/// Per body and node.
using Touchable = std::vector<std::vector<char>>;

/// Nodes of the contacts' facets that lie in their fine zones, or pass through them while a support turns their body,
/// and one ring beyond; of a contact without fine zone those nearer to the other side than the drawn distance and two
/// facets.
Touchable touchable_nodes(const SolidProblem& problem, const SolidMeshes& meshes);

/// Nodes of all faces of contacts: touchable ones are among them.
Touchable contact_nodes(const SolidProblem& problem, const SolidMeshes& meshes);

/// Adds the nodes of those facets of a face whose middle is nearer to one of the places than their size.
void take_beside(const mesh::SolidMesh& mesh, const std::string& face, const Points3& places, std::vector<char>& nodes);

/// Adds rings of facets of the contacts' faces; false where there is nothing to add.
bool grow(const SolidProblem& problem, const SolidMeshes& meshes, Touchable& touchable, int rings);

}  // namespace reye::sim
