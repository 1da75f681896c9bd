#include "body/control_points.hpp"

#include <set>

namespace reye::body {

std::vector<mesh::LineFacet> curved_edges(const mesh::Mesh& mesh, const std::vector<std::string>& boundaries) {
  if (mesh::order(mesh.kind) == 1) return {};
  std::set<int> seen;
  std::vector<mesh::LineFacet> edges;
  for (const auto& name : boundaries)
    for (const auto& chain : mesh.boundaries.at(name))
      for (std::size_t i = 0; i + 2 < chain.size(); i += 2)
        if (seen.insert(chain[i + 1]).second) edges.push_back({chain[i], chain[i + 2], chain[i + 1]});
  return edges;
}

}  // namespace reye::body
