#include "cad/solid/solid_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace reye::cad {

namespace {

using base::Mat3;
using base::Vec3;

constexpr std::array<std::array<int, 2>, 6> tet_edges = {{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).dot((c - a).cross(d - a));
}

double mean_ratio(const Points3& X, const mesh::SolidCell& cell) {
  const double volume = six_volumes(X[cell[0]], X[cell[1]], X[cell[2]], X[cell[3]]) / 6.0;
  double squares = 0.0;
  for (const auto& [a, b] : tet_edges) squares += (X[cell[a]] - X[cell[b]]).squaredNorm();
  return std::copysign(12.0 * std::cbrt(9.0 * volume * volume), volume) / squares;
}

/// det(dX/dxi) of a second-order tetrahedron at barycentric coordinates L.
double tet10_determinant(const Points3& X, const mesh::SolidCell& cell, const std::array<double, 4>& L) {
  std::array<Vec3, 4> by_L;  // dX/dL_i
  for (int i = 0; i < 4; ++i) by_L[i] = (4.0 * L[i] - 1.0) * X[cell[i]];
  for (int e = 0; e < 6; ++e) {
    const auto& [a, b] = tet_edges[e];
    by_L[a] += 4.0 * L[b] * X[cell[4 + e]];
    by_L[b] += 4.0 * L[a] * X[cell[4 + e]];
  }
  return six_volumes(by_L[0], by_L[1], by_L[2], by_L[3]);
}

/// The points of a lattice of this order.
std::vector<std::array<double, 4>> lattice(int order) {
  std::vector<std::array<double, 4>> points;
  for (int i = 0; i <= order; ++i)
    for (int j = 0; i + j <= order; ++j)
      for (int k = 0; i + j + k <= order; ++k)
        points.push_back({1.0 * i / order, 1.0 * j / order, 1.0 * k / order, 1.0 * (order - i - j - k) / order});
  return points;
}

double least_of_tet10(const Points3& X, const mesh::SolidCell& cell) {
  static const auto points = [] {
    auto all = lattice(3);
    for (const auto& more : {lattice(2), lattice(4)}) all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  const double straight = six_volumes(X[cell[0]], X[cell[1]], X[cell[2]], X[cell[3]]);
  if (!(straight > 0.0)) return straight == 0.0 ? 0.0 : -1.0;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& L : points) least = std::min(least, tet10_determinant(X, cell, L));
  return least / straight;
}

double least_of_hex8(const Points3& X, const mesh::SolidCell& cell) {
  // Of each corner: its neighbours along the three local axes, counter-clockwise.
  constexpr int next[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 8; ++k) {
    const Vec3& p = X[cell[k]];
    const Vec3 a = X[cell[next[k][0]]] - p, b = X[cell[next[k][1]]] - p, c = X[cell[next[k][2]]] - p;
    least = std::min(least, a.dot(b.cross(c)) / (a.norm() * b.norm() * c.norm()));
  }
  return std::isfinite(least) ? least : 0.0;
}

}  // namespace

double worst_mean_ratio(const RawSolidMesh& mesh) {
  double worst = 1.0;
  if (mesh.kind == mesh::SolidKind::hex8) return worst;
  for (const mesh::SolidCell& cell : mesh.cells) worst = std::min(worst, mean_ratio(mesh.nodes, cell));
  return worst;
}

double least_jacobian(const Points3& X, mesh::SolidKind kind, const mesh::SolidCell& cell) {
  if (kind == mesh::SolidKind::tet10) return least_of_tet10(X, cell);
  return kind == mesh::SolidKind::hex8 ? least_of_hex8(X, cell) : mean_ratio(X, cell);
}

int straighten_bad_cells(RawSolidMesh& mesh) {
  constexpr double least = 0.2;
  std::set<int> moved;
  if (mesh.kind != mesh::SolidKind::tet10) return 0;
  for (bool again = true; again;) {
    again = false;
    for (const mesh::SolidCell& cell : mesh.cells) {
      if (least_of_tet10(mesh.nodes, cell) >= least) continue;
      for (int e = 0; e < 6; ++e) {
        const auto& [a, b] = tet_edges[e];
        const Vec3 &p = mesh.nodes[cell[a]], &q = mesh.nodes[cell[b]], middle = 0.5 * (p + q);
        if ((mesh.nodes[cell[4 + e]] - middle).norm() <= 1e-9 * (p - q).norm()) continue;
        mesh.nodes[cell[4 + e]] = middle;
        moved.insert(cell[4 + e]);
        again = true;
      }
    }
  }
  return static_cast<int>(moved.size());
}

}  // namespace reye::cad
