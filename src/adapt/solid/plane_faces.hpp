#pragma once
#include <set>

#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

/// Moves the nodes of plane faces that did not wear, in their planes, after edges of theirs that have moved since
/// birth: first the nodes of straight edges between two of them, or of one and a face that neither wore nor follows, in
/// proportion to their place there, then those inside, by the least sum of 1/area int |grad v|^2. Faces are groups of
/// facets that are plane at birth and still lie in that plane; those in `worn` are left alone. Displacements count from
/// birth, hence without memory. (README, 15)
void slide_plane_faces(mesh::SolidMesh& mesh, const mesh::SolidMesh& born, const std::set<int>& worn);

}  // namespace reye::adapt
