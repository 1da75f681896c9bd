#include "mesh/mesh.hpp"

#include <unordered_set>

namespace reye::mesh {

std::vector<int> nodes_of(const Boundary& boundary) {
  std::vector<int> nodes;
  std::unordered_set<int> seen;
  for (const auto& chain : boundary)
    for (int node : chain)
      if (seen.insert(node).second) nodes.push_back(node);
  return nodes;
}

}  // namespace reye::mesh
