#pragma once
#include <functional>

#include "mesh/mesh.hpp"
#include "mesh/solid/solid_skin.hpp"

namespace reye::support {

/// Layers of hexahedra over a plane mesh of quadrilaterals: `place` puts its nodes at shares from 0 to 1 of the way;
/// the nodes of layer k have their number plus k times their count. Boundaries become faces of the same name, the two
/// sides are "z0" and "z1".
inline mesh::SolidMesh swept(const mesh::Mesh& plane, int layers,
                             const std::function<base::Vec3(const base::Vec2&, double)>& place) {
  const int n = plane.node_count();
  mesh::SolidMesh solid;
  solid.kind = mesh::SolidKind::hex8;
  for (int k = 0; k <= layers; ++k)
    for (const auto& X : plane.X) solid.X.push_back(place(X, static_cast<double>(k) / layers));
  for (int k = 0; k < layers; ++k)
    for (const auto& c : plane.cells) {
      mesh::SolidCell cell;
      cell.fill(-1);
      for (int a = 0; a < 4; ++a) {
        cell[a] = c[a] + k * n;
        cell[a + 4] = c[a] + (k + 1) * n;
      }
      solid.cells.push_back(cell);
    }
  solid.skin = mesh::faces_of_one_cell(solid.kind, solid.cells);
  mesh::group_by_angle(solid.X, solid.skin);
  std::map<std::pair<int, int>, std::string> names;
  for (const auto& [name, boundary] : plane.boundaries)
    for (const auto& chain : boundary)
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) names[std::minmax(chain[k], chain[k + 1])] = name;
  for (int f = 0; f < static_cast<int>(solid.skin.size()); ++f) {
    std::vector<int> layer, edge;
    for (const int node : solid.skin[f].nodes)
      if (node >= 0) layer.push_back(node / n), edge.push_back(node % n);
    const auto [low, high] = std::minmax_element(layer.begin(), layer.end());
    if (*low == *high) {
      solid.faces[*low == 0 ? "z0" : "z1"].push_back(f);
      continue;
    }
    const auto [a, b] = std::minmax_element(edge.begin(), edge.end());
    if (const auto found = names.find({*a, *b}); found != names.end()) solid.faces[found->second].push_back(f);
  }
  return solid;
}

/// One layer, straight out of the plane.
inline mesh::SolidMesh extruded(const mesh::Mesh& plane, double thickness) {
  return swept(plane, 1, [=](const base::Vec2& X, double t) { return base::Vec3(X.x(), X.y(), thickness * t); });
}

}  // namespace reye::support
