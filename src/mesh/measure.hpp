#pragma once
#include <array>
#include <vector>

#include "mesh/mesh.hpp"

/// Lengths, areas and normals of meshes made of straight edges. Geometry only: no quadrature.
namespace reye::mesh {

/// Signed area enclosed by a closed chain [mm^2]: 1/2 sum x_i cross x_{i+1}; positive counter-clockwise.
double enclosed_area(const Points& X, const Chain& loop);

/// Area of one cell [mm^2], positive counter-clockwise.
double cell_area(const Points& X, CellKind kind, const Cell& cell);

/// Area of the body [mm^2]; of a body without cells that inside its outline.
double area(const Mesh& mesh);

/// x_min, y_min, x_max, y_max of all nodes.
std::array<double, 4> bounding_box(const Points& X);

double length(const Points& X, const Chain& chain);
double length(const Points& X, const Boundary& boundary);

/// Outward unit normal of the straight edge from a to b, body on the left.
Vec2 outward_normal(const Vec2& a, const Vec2& b);

/// Position of each node along a chain [mm], aligned with the chain. Zero is the end with the smaller x
/// (ties: smaller y), whatever the direction of the chain. A closed chain is measured from its first node onward;
/// its last entry is the whole length.
std::vector<double> arc_lengths(const Points& X, const Chain& chain);

/// Arc length of the distinct nodes of a boundary, aligned with nodes_of(boundary): chains follow one another
/// in the order of the smaller x of their ends, each starting with the arc length at which the last one ended.
std::vector<double> arc_lengths(const Points& X, const Boundary& boundary);

/// Length belonging to each distinct node, half of each edge that meets it [mm], aligned with nodes_of(boundary).
std::vector<double> nodal_lengths(const Points& X, const Boundary& boundary);

}  // namespace reye::mesh
