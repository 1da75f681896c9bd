#pragma once
#include "cad/solid/raw_solid.hpp"

/// Shapes of cells.
namespace reye::cad {

/// The worst of a mesh's corners-only tetrahedra by 12 (3 V)^(2/3) / sum of squared edges: 1 regular, 0 flat (Liu &
/// Joe 1994); of hexahedra and of skins without cells 1.
double worst_mean_ratio(const RawSolidMesh& mesh);

/// The least Jacobian of a cell over its mean size: at corners of tet4 and hex8, and of tet10 over the cell (at the 20
/// points of the cubic lattice and the mid nodes), as a share of that of the straight cell. Positive: the cell is
/// sound.
double least_jacobian(const Points3& X, mesh::SolidKind kind, const mesh::SolidCell& cell);

/// Puts mid nodes of second-order cells into the middle of their edges where curved edges take more than four fifths of
/// a cell's Jacobian. Returns how many edges became straight.
int straighten_bad_cells(RawSolidMesh& mesh);

}  // namespace reye::cad
