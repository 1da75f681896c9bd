#pragma once
#include "mesh/mesh.hpp"
#include "mesh/outline.hpp"

/// Small meshes for the tests of the mesh room.
namespace reye::mesh {

/// n x n unit squares with lower left corner at the origin, row by row; `holes` are left out.
inline Mesh squares(int n, const std::vector<int>& holes = {}) {
  Mesh mesh;
  std::vector<int> number((n + 1) * (n + 1), -1);
  const auto node = [&](int i, int j) {
    int& known = number[j * (n + 1) + i];
    if (known < 0) {
      known = mesh.node_count();
      mesh.X.emplace_back(i, j);
    }
    return known;
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      bool left_out = false;
      for (int hole : holes) left_out = left_out || hole == j * n + i;
      if (!left_out) mesh.cells.push_back(cell_of({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}));
    }
  mesh.outline = outline_of(mesh.X, mesh.kind, mesh.cells);
  return mesh;
}

}  // namespace reye::mesh
