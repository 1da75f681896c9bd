#pragma once
#include "mesh/mesh.hpp"

/// The cells of two meshes cut with each other.
namespace reye::adapt {

/// The intersection of an old and a new cell: a convex polygon, counter-clockwise [mm], counted `sign` times. A cell
/// that is not convex has several, some of which may count -1: their sum is the winding number of its outline.
struct Overlap {
  int to = 0, from = 0;
  double sign = 1.0;
  base::Points polygon;
};

/// All overlaps, ordered by new, then by old cell. Sides are decided by exact predicates, corners are rounded:
/// the areas of the overlaps of a cell add up to its own to round-off where both meshes cover it. Curved edges of
/// second order count as the two chords through their mid node. n log^2 n.
std::vector<Overlap> overlaps(const mesh::Mesh& from, const mesh::Mesh& to);

}  // namespace reye::adapt
