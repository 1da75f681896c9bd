#pragma once
#include <string>
#include <vector>

#include "cad/part/part.hpp"
#include "mesh/mesh.hpp"

namespace reye::adapt {

/// Where the edges of a drawing lie on the outline of a mesh made from it.
struct Trace {
  std::vector<std::vector<int>> start;  ///< [loop][edge]: place in the outline loop of the node the edge starts at
  std::string failure;                  ///< empty; else where drawing and outline do not fit
};

/// Every edge starts at the outline node nearest to its first point, and edges follow one another round the loop.
/// X: positions of the mesh's nodes to be compared with the drawing.
Trace trace(const std::vector<cad::Loop>& loops, const std::vector<mesh::Chain>& outline, const base::Points& X);

/// Nodes of a closed outline loop on one of its edges, both ends included.
std::vector<int> nodes_on(const mesh::Chain& loop, const std::vector<int>& start, std::size_t edge);

}  // namespace reye::adapt
