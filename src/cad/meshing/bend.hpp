#pragma once
#include "cad/part/part.hpp"
#include "mesh/mesh.hpp"

namespace reye::cad {

/// The edge of each loop on which the piece of the outline from its i-th to its next vertex lies.
using EdgesUnder = std::vector<std::vector<int>>;

/// The mesh with a mid node on every edge: inside the body in the middle, on the outline on the curve, at the point
/// nearest to the middle. An edge that would bend its cell too much, or fold it over, stays straight.
mesh::Mesh second_order(const mesh::Mesh& linear, const std::vector<Loop>& loops, const EdgesUnder& under);

/// The mesh with mid nodes on every edge, on the outline at those of the mesh `outline`, which has the same vertices.
mesh::Mesh second_order(const mesh::Mesh& linear, const mesh::Mesh& outline);

}  // namespace reye::cad
