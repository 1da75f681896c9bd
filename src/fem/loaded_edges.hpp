#pragma once
#include <array>
#include <vector>

#include "fem/loads.hpp"
#include "mesh/mesh.hpp"

namespace reye::fem {

/// What a load covers of one edge of the outline: its nodes (first, last, or first, mid, last) and the covered part in
/// the parameter of the edge, from -1 (first) to 1 (last).
struct LoadedEdge {
  std::array<int, 3> nodes{-1, -1, -1};
  int count = 2;
  double from = -1.0, to = 1.0;
};

/// All edges that a load covers, cut by its interval as `load_vector` says.
/// Throws base::InputError when the edge is unknown or the interval meets none of it.
std::vector<LoadedEdge> loaded_edges(const mesh::Mesh& mesh, const BoundaryLoad& load);

}  // namespace reye::fem
