#pragma once
#include <vector>

#include "mesh/solid/solid_mesh.hpp"

namespace reye::body {

/// What condensing a solid to `retained` nodes takes.
struct SolidCost {
  double factor_entries = 0.0;  ///< of L
  double memory_MB = 0.0;  ///< at its peak: L, the stiffness, dense matrices of what is retained; of the largest rank
  double seconds = 0.0;    ///< of one CPU, or of all ranks
  int ranks = 1;           ///< that hold the factor (algebra/ranks.hpp)
};

/// From nested dissection and symbolic analysis of the graph of nodes, without supports: a per cent of the factor's own
/// time. A rigid body (no cells) costs its dense matrix alone.
SolidCost solid_cost(const mesh::SolidMesh& mesh, const std::vector<int>& retained);

}  // namespace reye::body
