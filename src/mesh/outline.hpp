#pragma once
#include <numbers>
#include <vector>

#include "mesh/mesh.hpp"

namespace reye::mesh {

/// An outline has a corner where its tangent turns by more.
constexpr double corner_angle = std::numbers::pi / 6.0;

inline bool is_closed(const Chain& chain) { return chain.size() > 2 && chain.front() == chain.back(); }

/// The closed loops bounding a set of counter-clockwise cells, body on the left: the loop of largest
/// enclosed area first, the others in order of their smallest vertex. Each loop starts at its smallest vertex.
/// Throws MeshError where two loops meet in one node, an edge belongs to more than two cells, or its cells differ in
/// its mid node.
std::vector<Chain> outline_of(const Points& X, CellKind kind, const std::vector<Cell>& cells);

/// Joins oriented edges (from, to) into chains in the order of the outline; consecutive edges make one chain,
/// a chain that covers a whole loop is closed. Edges are given as outline edges: `selected[loop][i]` says
/// whether the piece from outline[loop][i] to outline[loop][i + 1] belongs (in second order both halves of an edge do).
Boundary chains_along(const std::vector<Chain>& outline, const std::vector<std::vector<bool>>& selected);

}  // namespace reye::mesh
