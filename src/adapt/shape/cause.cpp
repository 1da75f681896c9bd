#include "adapt/shape/cause.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

#include "mesh/measure.hpp"

namespace reye::adapt {

namespace {

using base::Vec2;

Vec2 centroid(const mesh::Mesh& mesh, int cell) {
  Vec2 sum = Vec2::Zero();
  const int n = mesh::nodes_per_cell(mesh.kind);
  for (int k = 0; k < n; ++k) sum += mesh.X[mesh.cells[cell][k]];
  return sum / n;
}

using FacetEnds = std::pair<int, int>;

/// Height of the cell behind every outline facet (half edge in second order): its area over the edge's length, twice
/// that for triangles.
std::map<FacetEnds, double> heights(const mesh::Mesh& mesh) {
  std::map<FacetEnds, double> result;
  for (const auto& loop : mesh.outline)
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) result[{loop[i], loop[i + 1]}] = 0.0;
  const int n = mesh::corners(mesh.kind);
  const bool halves = mesh::order(mesh.kind) == 2;
  for (const auto& cell : mesh.cells)
    for (int k = 0; k < n; ++k) {
      const int a = cell[k], b = cell[(k + 1) % n];
      const auto first = result.find({a, halves ? cell[n + k] : b});
      if (first == result.end()) continue;
      first->second = (n == 3 ? 2.0 : 1.0) * mesh::cell_area(mesh.X, mesh.kind, cell) / (mesh.X[b] - mesh.X[a]).norm();
      if (halves) result.at({cell[n + k], b}) = first->second;
    }
  return result;
}

}  // namespace

std::map<int, double> wear_in_elements(const mesh::Mesh& now, const mesh::Mesh& born) {
  std::map<int, double> depth;
  for (const auto& [facet, height] : heights(born))
    for (int node : {facet.first, facet.second}) {
      const Vec2 t = (born.X[facet.second] - born.X[facet.first]).normalized();
      if (height > 0.0) depth[node] = std::max(depth[node], base::cross(t, now.X[node] - born.X[node]) / height);
    }
  return depth;
}

double wear_in_elements(const mesh::Mesh& now, const mesh::Mesh& born, const Vec2& place) {
  double nearest = std::numeric_limits<double>::infinity(), wear = 0.0;
  for (const auto& [node, value] : wear_in_elements(now, born))
    if (const double d = (now.X[node] - place).norm(); value > 1e-9 && d < nearest) {
      nearest = d;
      wear = value;
    }
  return wear;
}

std::string cause(const mesh::Mesh& now, const mesh::Mesh& born, const Vec2& place) {
  std::ostringstream text;
  text << ": wear since the mesh was made is " << wear_in_elements(now, born, place)
       << " times the height of the element below";
  return text.str();
}

std::string poor_cell_report(const mesh::Mesh& now, const mesh::Mesh& born, const mesh::PoorestCell& poorest,
                             double bound) {
  const Vec2 at = centroid(now, poorest.cell);
  std::ostringstream text;
  text << "element " << poorest.cell << " at (" << at.x() << ", " << at.y() << ") mm has scaled Jacobian "
       << poorest.scaled_jacobian << ", below " << bound;
  text << cause(now, born, at);
  return text.str();
}

}  // namespace reye::adapt
