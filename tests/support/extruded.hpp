#pragma once
#include "mesh/mesh.hpp"
#include "mesh/solid/solid_skin.hpp"

namespace reye::support {

/// One layer of hexahedra over a plane mesh of quadrilaterals: the nodes at z = 0 keep their numbers, those at z =
/// `thickness` follow; boundaries become faces of the same name, the two plane sides are "z0" and "z1".
inline mesh::SolidMesh extruded(const mesh::Mesh& plane, double thickness) {
  const int n = plane.node_count();
  mesh::SolidMesh solid;
  solid.kind = mesh::SolidKind::hex8;
  for (const double z : {0.0, thickness})
    for (const auto& X : plane.X) solid.X.push_back({X.x(), X.y(), z});
  for (const auto& c : plane.cells)
    solid.cells.push_back({c[0], c[1], c[2], c[3], c[0] + n, c[1] + n, c[2] + n, c[3] + n, -1, -1});
  solid.skin = mesh::faces_of_one_cell(solid.kind, solid.cells);
  mesh::group_by_angle(solid.X, solid.skin);
  std::map<std::pair<int, int>, std::string> names;
  for (const auto& [name, boundary] : plane.boundaries)
    for (const auto& chain : boundary)
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) names[std::minmax(chain[k], chain[k + 1])] = name;
  for (int f = 0; f < static_cast<int>(solid.skin.size()); ++f) {
    std::vector<int> low;
    for (const int node : solid.skin[f].nodes)
      if (node >= 0 && node < n) low.push_back(node);
    if (low.size() == 2) {
      if (const auto found = names.find(std::minmax(low[0], low[1])); found != names.end())
        solid.faces[found->second].push_back(f);
    } else {
      solid.faces[low.empty() ? "z1" : "z0"].push_back(f);
    }
  }
  return solid;
}

}  // namespace reye::support
