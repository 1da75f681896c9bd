#include "adapt/solid/worn_skin.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/formatted.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "mesh/solid/solid_shape.hpp"

namespace reye::adapt {

namespace {

/// The skin's facets at a node that are among `chosen`.
std::vector<int> chosen_facets(std::span<const int> at_node, const std::vector<char>& chosen) {
  std::vector<int> facets;
  for (int f : at_node)
    if (chosen[f]) facets.push_back(f);
  return facets;
}

bool is_middle(const mesh::Facet& facet, int node) {
  return std::find(facet.nodes.begin() + mesh::facet_corners(facet.kind), facet.nodes.begin() + facet.count(), node) !=
         facet.nodes.begin() + facet.count();
}

void add_losses(const mesh::SolidMesh& mesh, const FacetsAtNodes& facets_at, const WornFace& worn,
                std::map<int, WornSkinNode>& found) {
  const auto nodes = mesh::nodes_of(mesh::facets_of(mesh, worn.face));
  if (nodes.size() != worn.removed.size())
    throw std::logic_error("face " + base::quoted(worn.face) + " has " + std::to_string(nodes.size()) +
                           " nodes, and not " + std::to_string(worn.removed.size()));
  std::vector<char> of_face(mesh.skin.size(), 0);
  for (int f : mesh.faces.at(worn.face)) of_face[f] = 1;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (!(worn.removed[k] > 0.0)) continue;
    WornSkinNode& node = found[nodes[k]];
    node.node = nodes[k];
    node.losses.push_back({worn.removed[k], chosen_facets(facets_at[nodes[k]], of_face)});
    node.middle = is_middle(mesh.skin[node.losses.back().facets.front()], nodes[k]);
  }
}

/// The mid nodes of the edges of touched facets that move with a worn node.
std::vector<MovingMiddle> moving_middles(const mesh::SolidMesh& mesh, const WornSkin& worn) {
  std::map<int, int> place;
  for (std::size_t k = 0; k < worn.nodes.size(); ++k) place[worn.nodes[k].node] = static_cast<int>(k);
  std::map<int, MovingMiddle> found;
  for (int f : worn.touched) {
    const mesh::Facet& facet = mesh.skin[f];
    for (int e = 0; facet.kind == mesh::FacetKind::tri6 && e < 3; ++e) {
      const auto [i, j] = mesh::edge_of(facet.kind, e);
      const std::array<int, 2> ends{facet.nodes[i], facet.nodes[j]};
      const int node = facet.nodes[3 + e];
      const auto own = place.find(node);
      if (own == place.end() && !place.contains(ends[0]) && !place.contains(ends[1])) continue;
      const auto [entry, fresh] = found.try_emplace(node);
      if (fresh) entry->second = {node, ends, {f, f}, own == place.end() ? -1 : own->second};
      entry->second.facets[1] = f;
    }
  }
  std::vector<MovingMiddle> middles;
  for (const auto& [node, middle] : found) middles.push_back(middle);
  return middles;
}

}  // namespace

FacetsAtNodes::FacetsAtNodes(int nodes, const std::vector<mesh::Facet>& skin)
    : begin_(static_cast<std::size_t>(nodes) + 1, 0) {
  for (const mesh::Facet& facet : skin)
    for (int a = 0; a < facet.count(); ++a) ++begin_[facet.nodes[a] + 1];
  for (int k = 0; k < nodes; ++k) begin_[k + 1] += begin_[k];
  facets_.resize(static_cast<std::size_t>(begin_.back()));
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  for (int f = 0; f < static_cast<int>(skin.size()); ++f)
    for (int a = 0; a < skin[f].count(); ++a) facets_[next[skin[f].nodes[a]]++] = f;
}

WornSkin worn_skin(const mesh::SolidMesh& mesh, const FacetsAtNodes& facets_at, const std::vector<WornFace>& worn) {
  std::map<int, WornSkinNode> found;
  for (const WornFace& face : worn) add_losses(mesh, facets_at, face, found);
  WornSkin result;
  for (auto& [node, loss] : found) {
    for (const FaceLoss& each : loss.losses) result.volume += each.volume;
    result.touched.insert(result.touched.end(), facets_at[node].begin(), facets_at[node].end());
    result.nodes.push_back(std::move(loss));
  }
  std::sort(result.touched.begin(), result.touched.end());
  result.touched.erase(std::unique(result.touched.begin(), result.touched.end()), result.touched.end());
  result.middles = moving_middles(mesh, result);
  return result;
}

std::string bad_loss(const std::vector<WornFace>& worn) {
  for (const auto& [face, removed] : worn)
    for (std::size_t k = 0; k < removed.size(); ++k)
      if (!(removed[k] >= 0.0 && removed[k] < 1e300))
        return "node " + std::to_string(k) + " of face " + base::quoted(face) +
               base::formatted(" loses a volume of %g mm^3", removed[k]);
  return {};
}

}  // namespace reye::adapt
