#include "adapt/solid/solid_wear.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "adapt/solid/skin_strip.hpp"
#include "base/formatted.hpp"
#include "cad/solid/skin_of.hpp"
#include "cad/solid/solid_shape.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "mesh/solid/solid_skin.hpp"

namespace reye::adapt {

namespace {

double volume_of_corners(const mesh::Points3& X, mesh::SolidKind kind, const mesh::SolidCell& cell) {
  if (kind == mesh::SolidKind::hex8) {
    double sum = 0.0;
    for (const auto& [xi, weight] : mesh::volume_rule(kind))
      sum += weight *
             base::Mat3(mesh::corners_of(X, kind, cell).lazyProduct(mesh::shape_gradients(kind, xi))).determinant();
    return sum;
  }
  const Vec3& o = X[cell[0]];
  return (X[cell[1]] - o).cross(X[cell[2]] - o).dot(X[cell[3]] - o) / 6.0;
}

bool has_straight_edges(const mesh::SolidMesh& mesh, const mesh::SolidCell& cell) {
  constexpr double straight = 1e-9;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = mesh::edge_of(mesh.kind, e);
    const Vec3 &a = mesh.X[cell[i]], &b = mesh.X[cell[j]];
    if ((mesh.X[cell[4 + e]] - 0.5 * (a + b)).squaredNorm() > straight * straight * (a - b).squaredNorm()) return false;
  }
  return true;
}

/// Per facet of the skin, the height of the cell behind it: its volume over the area of the facet, three times that of
/// tetrahedra. Of rigid bodies the smallest height of the facet.
std::vector<double> heights_below(const mesh::SolidMesh& mesh) {
  std::vector<double> heights(mesh.skin.size());
  for (std::size_t f = 0; f < mesh.skin.size(); ++f)
    heights[f] = smallest_height(mesh.skin[f].kind, points_of(mesh.X, mesh.skin[f]));
  std::map<cad::FacetCorners, std::size_t> place;
  std::vector<char> on_skin(mesh.X.size(), 0);
  for (std::size_t f = 0; f < mesh.skin.size(); ++f) {
    place[cad::sorted_corners(mesh.skin[f])] = f;
    for (int a = 0; a < mesh.skin[f].count(); ++a) on_skin[mesh.skin[f].nodes[a]] = 1;
  }
  const bool hex = mesh.kind == mesh::SolidKind::hex8;
  const int corners = hex ? 8 : 4;
  for (const mesh::SolidCell& cell : mesh.cells) {
    if (std::count_if(cell.begin(), cell.begin() + corners, [&](int node) { return on_skin[node]; }) < 3) continue;
    for (int side = 0; side < (hex ? 6 : 4); ++side) {
      const mesh::Facet facet = mesh::face_of(mesh.kind, cell, side);
      const auto found = place.find(cad::sorted_corners(facet));
      if (found != place.end())
        heights[found->second] =
            (hex ? 1.0 : 3.0) * volume_of_corners(mesh.X, mesh.kind, cell) / mesh::facet_area(mesh.X, facet);
    }
  }
  return heights;
}

}  // namespace

std::vector<double> wear_in_elements(const mesh::SolidMesh& now, const mesh::SolidMesh& born) {
  std::vector<double> wear(now.X.size(), 0.0);
  const auto heights = heights_below(born);
  for (std::size_t f = 0; f < born.skin.size(); ++f) {
    const mesh::Facet& facet = born.skin[f];
    const Vec3 n = mesh::facet_normal(born.X, facet);
    for (int a = 0; a < facet.count(); ++a) {
      const int node = facet.nodes[a];
      wear[node] = std::max(wear[node], n.dot(born.X[node] - now.X[node]) / heights[f]);
    }
  }
  return wear;
}

std::string cause(const mesh::SolidMesh& now, const mesh::SolidMesh& born, const mesh::Vec3& place) {
  const auto wear = wear_in_elements(now, born);
  double nearest = std::numeric_limits<double>::infinity(), value = 0.0;
  for (std::size_t node = 0; node < wear.size(); ++node)
    if (const double d = (now.X[node] - place).norm(); wear[node] > 1e-9 && d < nearest) {
      nearest = d;
      value = wear[node];
    }
  return base::formatted(": wear since the mesh was made is %.3g times the height of the element below", value);
}

double worn_quality(const mesh::SolidMesh& mesh, int cell) {
  const double straight = mesh::shape_quality(mesh.X, mesh.kind, mesh.cells[cell]);
  if (mesh.kind != mesh::SolidKind::tet10 || !(straight > 0.0) || has_straight_edges(mesh, mesh.cells[cell]))
    return straight;
  return straight * std::min(1.0, cad::least_jacobian(mesh.X, mesh.kind, mesh.cells[cell]));
}

WornCells worn_cells(const mesh::SolidMesh& now, const mesh::SolidMesh& born, double bound) {
  constexpr double much = 0.9;
  std::vector<char> moved(now.X.size(), 0);
  for (std::size_t node = 0; node < moved.size(); ++node) moved[node] = now.X[node] != born.X[node];
  WornCells worn;
  for (int cell = 0; cell < now.cell_count(); ++cell) {
    const auto& nodes = now.cells[cell];
    const bool changed =
        std::any_of(nodes.begin(), nodes.begin() + mesh::solid_nodes(now.kind), [&](int node) { return moved[node]; });
    const double quality = changed ? worn_quality(now, cell) : mesh::shape_quality(now.X, now.kind, nodes);
    worn.least = std::min(worn.least, quality);
    if (!changed || quality >= bound || (worn.unfit.cell >= 0 && quality >= worn.unfit.quality)) continue;
    if (quality < much * worn_quality(born, cell)) worn.unfit = {cell, quality};
  }
  return worn;
}

std::string poor_cell_report(const mesh::SolidMesh& now, const mesh::SolidMesh& born,
                             const mesh::PoorestSolidCell& poorest, double bound) {
  Vec3 at = Vec3::Zero();
  const int n = mesh::solid_nodes(now.kind);
  for (int a = 0; a < n; ++a) at += now.X[now.cells[poorest.cell][a]] / n;
  return base::formatted("element %d at (%.6g, %.6g, %.6g) mm has shape %.3g, below %g", poorest.cell, at.x(), at.y(),
                         at.z(), poorest.quality, bound) +
         cause(now, born, at);
}

}  // namespace reye::adapt
