#pragma once
#include <vector>

#include "mesh/solid/solid_shape.hpp"

/// Bernstein control points of tri6 facets in place of their mid nodes, of positions and displacements alike.
namespace reye::mesh {

/// Values at nodes with those of control points in place of those of mid nodes, b = 2 x_m - (x_1 + x_2) / 2.
template <class V>
std::vector<V> control_points(const std::vector<Facet>& facets, const std::vector<V>& values) {
  std::vector<V> changed = values;
  for (const Facet& facet : facets)
    for (int e = 0; facet.kind == FacetKind::tri6 && e < 3; ++e) {
      const auto [i, j] = edge_of(facet.kind, e);
      const int m = facet.nodes[3 + e];
      changed[m] = 2.0 * values[m] - 0.5 * (values[facet.nodes[i]] + values[facet.nodes[j]]);
    }
  return changed;
}

/// Values at mid nodes from those at control points, x_m = b / 2 + (x_1 + x_2) / 4.
template <class V>
std::vector<V> middle_nodes(const std::vector<Facet>& facets, const std::vector<V>& values) {
  std::vector<V> changed = values;
  for (const Facet& facet : facets)
    for (int e = 0; facet.kind == FacetKind::tri6 && e < 3; ++e) {
      const auto [i, j] = edge_of(facet.kind, e);
      const int m = facet.nodes[3 + e];
      changed[m] = 0.5 * values[m] + 0.25 * (values[facet.nodes[i]] + values[facet.nodes[j]]);
    }
  return changed;
}

}  // namespace reye::mesh
