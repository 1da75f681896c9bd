#pragma once
#include "mesh/mesh.hpp"

namespace reye::mesh {

/// Smallest scaled Jacobian over the corners of a cell: the sine of the corner angle,
/// (e1 x e2) / (|e1| |e2|). 1 for a rectangle, 0.866 for the equilateral triangle, <= 0 when a corner is inverted.
/// For a bilinear quad det J is linear along each edge and bilinear inside: positive corners mean positive everywhere.
/// In second order: that of the cell with straight edges, times the smallest ratio (at most 1) of det J to its det J at
/// the nodes, the centre and half way between it and the corners; a cell with straight edges and centred mid nodes has
/// the value of its corners.
double scaled_jacobian(const Points& X, CellKind kind, const Cell& cell);

/// Smallest angle between the chords at the corners of a cell [rad], in (0, pi); of an inverted corner negative.
double smallest_angle(const Points& X, CellKind kind, const Cell& cell);

/// The poorest cell of a mesh and its scaled Jacobian; cell -1 for a mesh without cells.
struct PoorestCell {
  int cell = -1;
  double scaled_jacobian = 1.0;
};
PoorestCell poorest_cell(const Mesh& mesh);

/// Checks the invariants of `Mesh`: finite nodes, indices in range, positive Jacobians, no orphan node, a closed
/// outline that is that of the cells with the outer loop first and counter-clockwise, boundaries made of outline edges
/// in outline direction. Throws base::MeshError naming the cell or node and where it is.
void check(const Mesh& mesh);

}  // namespace reye::mesh
