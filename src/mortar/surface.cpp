#include "mortar/surface.hpp"

#include <cmath>
#include <numbers>
#include <unordered_map>

namespace reye::mortar {

namespace {

constexpr double corner_angle = 50.0 * std::numbers::pi / 180.0;

/// int N_j over one facet for both its nodes; in axisymmetry int N_j 2 pi r.
std::array<double, 2> shares(const Vec2& a, const Vec2& b, Analysis analysis) {
  const double length = (b - a).norm();
  if (analysis != Analysis::axisymmetric) return {0.5 * length, 0.5 * length};
  const double c = 2.0 * std::numbers::pi * length / 6.0;
  return {c * (2.0 * a.x() + b.x()), c * (a.x() + 2.0 * b.x())};
}

void find_corners(Surface& s) {
  s.corner.assign(s.X.size(), 0);
  for (int j = 0; j < s.node_count(); ++j) {
    if (s.before[j] < 0 || s.after[j] < 0) continue;
    const auto [a, b] = s.facets[s.before[j]];
    const auto [c, d] = s.facets[s.after[j]];
    const Vec2 t1 = (s.X[b] - s.X[a]).normalized(), t2 = (s.X[d] - s.X[c]).normalized();
    s.corner[j] = std::acos(std::clamp(t1.dot(t2), -1.0, 1.0)) > corner_angle;
  }
}

}  // namespace

Surface make_surface(const Points& X, const mesh::Boundary& boundary, Analysis analysis, std::vector<int>& nodes) {
  nodes = mesh::nodes_of(boundary);
  std::unordered_map<int, int> local;
  Surface s;
  for (int node : nodes) {
    local[node] = s.node_count();
    s.X.push_back(X[node]);
  }
  s.before.assign(nodes.size(), -1);
  s.after.assign(nodes.size(), -1);
  s.area.assign(nodes.size(), 0.0);
  for (const auto& chain : boundary)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const int a = local[chain[i]], b = local[chain[i + 1]];
      s.after[a] = s.before[b] = s.facet_count();
      s.facets.push_back({a, b});
      const auto share = shares(s.X[a], s.X[b], analysis);
      s.area[a] += share[0];
      s.area[b] += share[1];
    }
  find_corners(s);
  return s;
}

Surface joined(const std::vector<Surface>& surfaces) {
  Surface all;
  for (const auto& s : surfaces) {
    const int nodes = all.node_count(), facets = all.facet_count();
    const auto shifted = [facets](int f) { return f < 0 ? -1 : f + facets; };
    for (const auto& [a, b] : s.facets) all.facets.push_back({a + nodes, b + nodes});
    for (int j = 0; j < s.node_count(); ++j) {
      all.X.push_back(s.X[j]);
      all.before.push_back(shifted(s.before[j]));
      all.after.push_back(shifted(s.after[j]));
      all.corner.push_back(s.corner[j]);
      all.area.push_back(s.area[j]);
    }
  }
  return all;
}

}  // namespace reye::mortar
