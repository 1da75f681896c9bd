#pragma once
#include <utility>
#include <vector>

#include "mesh/solid/solid_mesh.hpp"

namespace reye::mesh {

/// Nodes and their shares (shape functions) at a point of a solid, of the cell that holds it. Of a point outside, at
/// most a tenth of a cell beside the mesh, those of the nearest cell; empty farther away, and for a rigid body.
std::vector<std::pair<int, double>> place_in(const SolidMesh& mesh, const Vec3& x);

}  // namespace reye::mesh
