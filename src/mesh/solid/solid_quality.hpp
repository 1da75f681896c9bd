#pragma once
#include "mesh/solid/solid_mesh.hpp"

namespace reye::mesh {

/// Shape of a cell, 1 of the regular one and 0 of a flat one: of tetrahedra 6 sqrt(2) V / l^3 with l the root mean
/// square of the six edges between corners, of hexahedra the smallest of their corners' (e1 x e2) . e3 / (|e1| |e2|
/// |e3|). Negative where folded over.
double shape_quality(const Points3& X, SolidKind kind, const SolidCell& cell);

/// The poorest cell of a mesh; cell -1 without cells.
struct PoorestSolidCell {
  int cell = -1;
  double quality = 1.0;
};
PoorestSolidCell poorest_cell(const SolidMesh& mesh);

/// Checks the invariants of `SolidMesh`: finite nodes, indices in range, every node in a cell (of a rigid body in the
/// skin), positive Jacobians at the points of the stiffness and at the corners of hexahedra, a closed skin that is that
/// of the cells and encloses a positive volume, faces made of facets of the skin. Throws base::MeshError naming the
/// cell, facet or node and where it is.
void check(const SolidMesh& mesh);

}  // namespace reye::mesh
