#include "output/solid/skin_edges.hpp"

#include <array>
#include <map>
#include <utility>

#include "mesh/solid/solid_measure.hpp"

namespace reye::output {

namespace {

struct HalfEdge {
  int group = 0;
  std::size_t edge = 0;
};

/// The nodes round a facet, closed.
std::vector<int> ring_of(const mesh::Facet& f) {
  const auto& n = f.nodes;
  if (f.kind == mesh::FacetKind::tri3) return {n[0], n[1], n[2], n[0]};
  if (f.kind == mesh::FacetKind::quad4) return {n[0], n[1], n[2], n[3], n[0]};
  return {n[0], n[3], n[1], n[4], n[2], n[5], n[0]};
}

}  // namespace

std::vector<SkinEdge> skin_edges(const mesh::SolidMesh& mesh) {
  constexpr double sharp = 0.82;  // cosine of 35 degrees
  std::vector<SkinEdge> edges;
  std::map<std::pair<int, int>, HalfEdge> open;
  for (const auto& facet : mesh.skin) {
    const base::Vec3 normal = mesh::area_vector(mesh.X, facet).normalized();
    const auto ring = ring_of(facet);
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
      const auto [entry, fresh] = open.try_emplace(std::minmax(ring[k], ring[k + 1]));
      if (fresh) {
        entry->second = {facet.group, edges.size()};
        edges.push_back({ring[k], ring[k + 1], normal, -normal, true});
        continue;
      }
      SkinEdge& edge = edges[entry->second.edge];
      edge.right = normal;
      edge.feature = entry->second.group != facet.group || edge.left.dot(normal) < sharp;
    }
  }
  return edges;
}

}  // namespace reye::output
