#pragma once
#include <array>
#include <vector>

#include "mesh/mesh.hpp"

/// Lengths, areas and normals of meshes: of straight edges, and of quadratic ones where the order is 2. Chains are read
/// by the `order` of the mesh they belong to.
namespace reye::mesh {

/// Signed area enclosed by a closed chain [mm^2]: 1/2 sum x_i cross x_{i+1} over its vertices, in second order and
/// what lies between the edges and their chords; positive counter-clockwise.
double enclosed_area(const Points& X, const Chain& loop, int order = 1);

/// Area of one cell [mm^2], positive counter-clockwise.
double cell_area(const Points& X, CellKind kind, const Cell& cell);

/// Area of the body [mm^2]; of a body without cells that inside its outline.
double area(const Mesh& mesh);

/// x_min, y_min, x_max, y_max of all nodes.
std::array<double, 4> bounding_box(const Points& X);

double length(const Points& X, const Chain& chain, int order = 1);
double length(const Points& X, const Boundary& boundary, int order = 1);

/// Outward unit normal of the straight edge from a to b, body on the left.
Vec2 outward_normal(const Vec2& a, const Vec2& b);

/// Parameter in [0, 1] of the point of the straight edge from a to b that is nearest to x.
double nearest_parameter(const Vec2& a, const Vec2& b, const Vec2& x);

/// Distance of x from the straight edge from a to b [mm].
double distance_to_edge(const Vec2& a, const Vec2& b, const Vec2& x);

/// Position of each node along a chain from its first one on [mm], aligned with the chain; of a closed one the last
/// entry is its whole length.
std::vector<double> arc_lengths(const Points& X, const Chain& chain, int order = 1);

/// Length belonging to each distinct node [mm], aligned with nodes_of(boundary): int N_j ds over the edges that meet in
/// it, half of each straight one; by five Gauss points where they are quadratic.
std::vector<double> nodal_lengths(const Points& X, const Boundary& boundary, int order = 1);

}  // namespace reye::mesh
