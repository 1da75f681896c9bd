#include "mortar/surface.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace reye::mortar {

namespace {

void find_corners(Surface& s) {
  s.corner.assign(s.X.size(), 0);
  for (int j = 0; j < s.node_count(); ++j) {
    if (s.before[j] < 0 || s.after[j] < 0 || s.is_control_point(j)) continue;
    const Vec2 t1 = (s.X[j] - s.X[s.beside(s.before[j], 1)]).normalized();
    const Vec2 t2 = (s.X[s.beside(s.after[j], 0)] - s.X[j]).normalized();
    s.corner[j] = std::acos(std::clamp(t1.dot(t2), -1.0, 1.0)) > mesh::smooth_angle;
  }
}

void add_facet(Surface& s, const LineFacet& facet) {
  const auto [a, b, c] = facet;
  s.after[a] = s.before[b] = s.facet_count();
  if (c >= 0) s.before[c] = s.after[c] = s.facet_count();
  s.facets.push_back(facet);
}

void add_area(Surface& s, const LineFacet& facet, Analysis analysis) {
  const auto [a, b, c] = facet;
  const auto share = mesh::nodal_shares(mesh::kind_of(facet), {s.X[a], s.X[b], s.X[c < 0 ? a : c]}, analysis);
  for (std::size_t j = 0; j < 3; ++j)
    if (facet[j] >= 0) s.area[facet[j]] += share[j];
}

}  // namespace

Surface make_surface(const Points& X, const mesh::Boundary& boundary, Analysis analysis, std::vector<int>& nodes,
                     int order) {
  nodes = mesh::nodes_of(boundary);
  std::unordered_map<int, int> local;
  Surface s;
  s.order = order;
  for (int node : nodes) {
    local[node] = s.node_count();
    s.X.push_back(X[node]);
  }
  s.before.assign(nodes.size(), -1);
  s.after.assign(nodes.size(), -1);
  s.area.assign(nodes.size(), 0.0);
  const auto step = static_cast<std::size_t>(order);
  for (const auto& chain : boundary)
    for (std::size_t i = 0; i + step < chain.size(); i += step)
      add_facet(s, {local[chain[i]], local[chain[i + step]], order == 2 ? local[chain[i + 1]] : -1});
  s.X = mesh::control_points(s.facets, std::move(s.X));
  for (const auto& facet : s.facets) add_area(s, facet, analysis);
  find_corners(s);
  return s;
}

Surface joined(const std::vector<Surface>& surfaces) {
  Surface all;
  for (const auto& s : surfaces) {
    const int nodes = all.node_count(), facets = all.facet_count();
    const auto shifted = [](int i, int by) { return i < 0 ? -1 : i + by; };
    all.order = std::max(all.order, s.order);
    for (const auto& [a, b, c] : s.facets) all.facets.push_back({a + nodes, b + nodes, shifted(c, nodes)});
    for (int j = 0; j < s.node_count(); ++j) {
      all.X.push_back(s.X[j]);
      all.before.push_back(shifted(s.before[j], facets));
      all.after.push_back(shifted(s.after[j], facets));
      all.corner.push_back(s.corner[j]);
      all.area.push_back(s.area[j]);
    }
  }
  return all;
}

}  // namespace reye::mortar
