#include "mesh/solid/solid_quality.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "mesh/solid/solid_skin.hpp"

namespace reye::mesh {

namespace {

std::string where(const Vec3& p) { return base::formatted(" at (%.6g, %.6g, %.6g)", p.x(), p.y(), p.z()); }

/// The three edges that leave each corner of a hexahedron, right-handed.
constexpr int hex_corner[8][3]{{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

double tet_quality(const Points3& X, const SolidCell& cell) {
  const Vec3 &o = X[cell[0]], a = X[cell[1]] - o, b = X[cell[2]] - o, c = X[cell[3]] - o;
  const double squares = a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + (a - b).squaredNorm() +
                         (b - c).squaredNorm() + (c - a).squaredNorm();
  return squares > 0.0 ? std::sqrt(2.0) * a.cross(b).dot(c) / std::pow(squares / 6.0, 1.5) : 0.0;
}

double hex_quality(const Points3& X, const SolidCell& cell) {
  double smallest = 1.0;
  for (int k = 0; k < 8; ++k) {
    const Vec3& o = X[cell[k]];
    const Vec3 a = X[cell[hex_corner[k][0]]] - o, b = X[cell[hex_corner[k][1]]] - o, c = X[cell[hex_corner[k][2]]] - o;
    const double lengths = a.norm() * b.norm() * c.norm();
    smallest = std::min(smallest, lengths > 0.0 ? a.cross(b).dot(c) / lengths : 0.0);
  }
  return smallest;
}

void mark_nodes(const SolidMesh& mesh, const std::string& owner, const int* nodes, int count, std::vector<char>& used) {
  for (int a = 0; a < count; ++a) {
    if (nodes[a] < 0 || nodes[a] >= mesh.node_count())
      throw base::MeshError(owner + " names node " + std::to_string(nodes[a]) + ", which does not exist");
    if (std::find(nodes, nodes + a, nodes[a]) != nodes + a)
      throw base::MeshError(owner + where(mesh.X[nodes[a]]) + " names node " + std::to_string(nodes[a]) + " twice");
    used[nodes[a]] = 1;
  }
}

void check_solid_nodes(const SolidMesh& mesh) {
  std::vector<char> used(mesh.X.size(), 0), on_skin = used;
  for (int c = 0; c < mesh.cell_count(); ++c)
    mark_nodes(mesh, "cell " + std::to_string(c), mesh.cells[c].data(), solid_nodes(mesh.kind), used);
  for (size_t f = 0; f < mesh.skin.size(); ++f)
    mark_nodes(mesh, "facet " + std::to_string(f), mesh.skin[f].nodes.data(), mesh.skin[f].count(),
               mesh.cells.empty() ? used : on_skin);
  for (int k = 0; k < mesh.node_count(); ++k) {
    if (!mesh.X[k].allFinite()) throw base::MeshError("node " + std::to_string(k) + " has no finite position");
    if (!used[k])
      throw base::MeshError("node " + std::to_string(k) + where(mesh.X[k]) + " belongs to no " +
                            (mesh.cells.empty() ? "facet" : "cell"));
  }
}

void check_jacobians(const SolidMesh& mesh) {
  std::vector<SolidGradients> gradients;
  for (const auto& point : stiffness_rule(mesh.kind)) gradients.push_back(shape_gradients(mesh.kind, point.xi));
  for (int a = 0; mesh.kind == SolidKind::hex8 && a < 8; ++a)
    gradients.push_back(shape_gradients(mesh.kind, reference_node(mesh.kind, a)));
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const auto x = corners_of(mesh.X, mesh.kind, mesh.cells[c]);
    for (const auto& d : gradients)
      if (!(base::Mat3(x * d).determinant() > 0.0))
        throw base::MeshError("cell " + std::to_string(c) + where(x.col(0)) + " is folded over or flat");
  }
}

/// Nodes begun with the smallest corner: equal for facets that are equal but for where they begin.
std::array<int, 6> key_of(const Facet& facet) {
  const int n = facet_corners(facet.kind);
  const auto first = std::min_element(facet.nodes.begin(), facet.nodes.begin() + n) - facet.nodes.begin();
  std::array<int, 6> key{-1, -1, -1, -1, -1, -1};
  for (int k = 0; k < facet.count(); ++k) key[k] = facet.nodes[k / n * n + (first + k) % n];
  return key;
}

void check_closed(const SolidMesh& mesh) {
  if (mesh.skin.empty()) throw base::MeshError("the solid has no skin");
  std::map<std::array<int, 3>, int> turns;  // edge with its mid node: how often one way less the other
  for (const Facet& facet : mesh.skin)
    for (int e = 0, n = facet_corners(facet.kind); e < n; ++e) {
      const int a = facet.nodes[e], b = facet.nodes[(e + 1) % n],
                m = facet.kind == FacetKind::tri6 ? facet.nodes[3 + e] : -1;
      turns[{std::min(a, b), std::max(a, b), m}] += a < b ? 1 : -1;
    }
  for (const auto& [edge, sum] : turns)
    if (sum != 0)
      throw base::MeshError("the skin is not closed, or its facets do not face the same way, along the edge" +
                            where(mesh.X[edge[0]]) + " to" + where(mesh.X[edge[1]]).substr(3));
  if (!(volume(mesh) > 0.0)) throw base::MeshError("the skin encloses no volume; its facets may face inwards");
}

void check_skin_of_cells(const SolidMesh& mesh) {
  std::vector<std::array<int, 6>> expected, skin;
  for (const Facet& facet : faces_of_one_cell(mesh.kind, mesh.cells)) expected.push_back(key_of(facet));
  for (size_t f = 0; f < mesh.skin.size(); ++f) {
    if (mesh.skin[f].kind != facet_kind(mesh.kind))
      throw base::MeshError("facet " + std::to_string(f) + where(mesh.X[mesh.skin[f].nodes[0]]) +
                            " is of another kind than the cells");
    skin.push_back(key_of(mesh.skin[f]));
  }
  std::sort(expected.begin(), expected.end());
  std::sort(skin.begin(), skin.end());
  const auto [a, b] = std::mismatch(skin.begin(), skin.end(), expected.begin(), expected.end());
  if (a == skin.end() && b == expected.end()) return;
  const bool surplus = b == expected.end() || (a != skin.end() && *a < *b);
  throw base::MeshError(std::string("the skin is not that of the cells: the facet") +
                        where(mesh.X[surplus ? (*a)[0] : (*b)[0]]) + (surplus ? " bounds no cell" : " is missing"));
}

}  // namespace

double shape_quality(const Points3& X, SolidKind kind, const SolidCell& cell) {
  return kind == SolidKind::hex8 ? hex_quality(X, cell) : tet_quality(X, cell);
}

PoorestSolidCell poorest_cell(const SolidMesh& mesh) {
  PoorestSolidCell poorest;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const double quality = shape_quality(mesh.X, mesh.kind, mesh.cells[cell]);
    if (poorest.cell < 0 || quality < poorest.quality) poorest = {cell, quality};
  }
  return poorest;
}

void check(const SolidMesh& mesh) {
  check_solid_nodes(mesh);
  check_jacobians(mesh);
  check_closed(mesh);
  if (!mesh.cells.empty()) check_skin_of_cells(mesh);
  for (const auto& [name, facets] : mesh.faces) {
    if (facets.empty()) throw base::MeshError("face " + base::quoted(name) + " has no facet");
    for (int f : facets)
      if (f < 0 || f >= static_cast<int>(mesh.skin.size()))
        throw base::MeshError("face " + base::quoted(name) + " names facet " + std::to_string(f) +
                              ", which does not exist");
  }
}

}  // namespace reye::mesh
