#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "mesh/solid/solid_measure.hpp"
#include "mesh/solid/solid_quality.hpp"
#include "mesh/solid/solid_skin.hpp"

/// Blocks of solids for tests: box [0, size] of nx x ny x nz hexahedra, or of six tetrahedra for each; faces "x0",
/// "x1", "y0" ... "z1".
namespace reye::support {

using base::Vec3;

namespace detail {

/// Splits hexahedra into six tetrahedra about the diagonal 0 - 6, which neighbours match.
inline std::vector<mesh::SolidCell> tetrahedra(const std::vector<mesh::SolidCell>& hexahedra) {
  static constexpr int parts[6][4]{{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  std::vector<mesh::SolidCell> cells;
  for (const auto& hex : hexahedra)
    for (const auto& part : parts) {
      mesh::SolidCell cell;
      cell.fill(-1);
      for (int a = 0; a < 4; ++a) cell[a] = hex[part[a]];
      cells.push_back(cell);
    }
  return cells;
}

inline void add_middle_nodes(mesh::SolidMesh& mesh) {
  std::map<std::pair<int, int>, int> middle;
  for (auto& cell : mesh.cells)
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = mesh::edge_of(mesh::SolidKind::tet10, e);
      const auto [place, fresh] = middle.try_emplace(std::minmax({cell[i], cell[j]}), mesh.node_count());
      if (fresh) mesh.X.push_back(0.5 * (mesh.X[cell[i]] + mesh.X[cell[j]]));
      cell[4 + e] = place->second;
    }
}

}  // namespace detail

/// Names the facets whose centroid satisfies `inside`.
inline void name_face(mesh::SolidMesh& mesh, const std::string& name, const std::function<bool(const Vec3&)>& inside) {
  for (int f = 0; f < static_cast<int>(mesh.skin.size()); ++f)
    if (inside(mesh::area_centroid(mesh.X, {mesh.skin[f]}))) mesh.faces[name].push_back(f);
}

/// `moved`: a change of the nodes' places after the faces have been named.
inline mesh::SolidMesh block(mesh::SolidKind kind, std::array<int, 3> count, const Vec3& size,
                             const std::function<Vec3(const Vec3&)>& moved = {}) {
  mesh::SolidMesh mesh;
  mesh.kind = kind;
  const auto [nx, ny, nz] = count;
  const auto node = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) mesh.X.push_back({size.x() * i / nx, size.y() * j / ny, size.z() * k / nz});
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        mesh.cells.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                              node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                              node(i, j + 1, k + 1), -1, -1});
  if (kind != mesh::SolidKind::hex8) mesh.cells = detail::tetrahedra(mesh.cells);
  if (kind == mesh::SolidKind::tet10) detail::add_middle_nodes(mesh);
  mesh.skin = mesh::skin_of(mesh.X, kind, mesh.cells);
  for (int axis = 0; axis < 3; ++axis)
    for (int end : {0, 1})
      name_face(mesh, std::string(1, "xyz"[axis]) + std::to_string(end),
                [&](const Vec3& c) { return std::abs(c[axis] - end * size[axis]) < 1e-9 * size[axis]; });
  if (moved)
    for (Vec3& X : mesh.X) X = moved(X);
  return mesh;
}

/// Bends every straight line; on planes and inside alike.
inline Vec3 distort(const Vec3& X) {
  return X + 0.06 * Vec3(std::sin(2.1 * X.y() + X.z()), std::sin(1.7 * X.z() - X.x()), std::sin(1.9 * X.x() + X.y()));
}

inline constexpr std::array solid_kinds{mesh::SolidKind::tet4, mesh::SolidKind::tet10, mesh::SolidKind::hex8};

}  // namespace reye::support
