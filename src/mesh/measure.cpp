#include "mesh/measure.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "mesh/facet.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::mesh {

namespace {

/// The quadratic edge that starts at place i of a chain.
QuadraticEdge edge_at(const Points& X, const Chain& chain, std::size_t i) {
  return {X[chain[i]], X[chain[i + 1]], X[chain[i + 2]]};
}

/// Length from each node of a chain to the next one.
std::vector<double> steps(const Points& X, const Chain& chain, int order) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    if (order == 1)
      result.push_back((X[chain[i + 1]] - X[chain[i]]).norm());
    else if (i % 2 == 0)
      result.push_back(edge_at(X, chain, i).length(-1.0, 0.0));
    else
      result.push_back(edge_at(X, chain, i - 1).length(0.0, 1.0));
  }
  return result;
}

/// int N_j ds of the three nodes of a quadratic edge.
Eigen::Vector3d shares(const QuadraticEdge& edge) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [xi, weight] : gauss5) sum += weight * edge.tangent(xi).norm() * QuadraticEdge::shape(xi);
  return sum;
}

}  // namespace

double enclosed_area(const Points& X, const Chain& loop, int order) {
  double twice = 0.0;
  const Vec2 shift = X[loop.front()];  // shifted to the loop, so that no digits are lost far from the origin
  for (std::size_t i = 0; i + order < loop.size(); i += order) {
    twice += base::cross(X[loop[i]] - shift, X[loop[i + order]] - shift);
    if (order == 2) twice += 2.0 * edge_at(X, loop, i).segment_area();
  }
  return 0.5 * twice;
}

double cell_area(const Points& X, CellKind kind, const Cell& cell) {
  const int n = corners(kind);
  double area = n == 3 ? 0.5 * base::cross(X[cell[1]] - X[cell[0]], X[cell[2]] - X[cell[0]])
                       : 0.5 * base::cross(X[cell[2]] - X[cell[0]], X[cell[3]] - X[cell[1]]);
  if (order(kind) == 1) return area;
  for (int k = 0; k < n; ++k) area += QuadraticEdge{X[cell[k]], X[cell[n + k]], X[cell[(k + 1) % n]]}.segment_area();
  return area;
}

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const Cell& cell : mesh.cells) sum += cell_area(mesh.X, mesh.kind, cell);
  if (mesh.cells.empty())
    for (const Chain& loop : mesh.outline) sum += enclosed_area(mesh.X, loop, order(mesh.kind));
  return sum;
}

std::array<double, 4> bounding_box(const Points& X) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 4> box{infinity, infinity, -infinity, -infinity};
  for (const Vec2& p : X)
    box = {std::min(box[0], p.x()), std::min(box[1], p.y()), std::max(box[2], p.x()), std::max(box[3], p.y())};
  return box;
}

double length(const Points& X, const Chain& chain, int order) {
  const std::vector<double> pieces = steps(X, chain, order);
  return std::accumulate(pieces.begin(), pieces.end(), 0.0);
}

double length(const Points& X, const Boundary& boundary, int order) {
  return std::accumulate(boundary.begin(), boundary.end(), 0.0,
                         [&](double sum, const Chain& chain) { return sum + length(X, chain, order); });
}

Vec2 outward_normal(const Vec2& a, const Vec2& b) { return base::right_of(b - a).normalized(); }

double nearest_parameter(const Vec2& a, const Vec2& b, const Vec2& x) {
  const Vec2 e = b - a, r = x - a;
  return std::clamp(e.dot(r) / e.squaredNorm(), 0.0, 1.0);
}

double distance_to_edge(const Vec2& a, const Vec2& b, const Vec2& x) {
  const Vec2 e = b - a, r = x - a;
  return (r - nearest_parameter(a, b, x) * e).norm();
}

std::vector<double> arc_lengths(const Points& X, const Chain& chain, int order) {
  const std::vector<double> pieces = steps(X, chain, order);
  std::vector<double> arc{0.0};
  for (double piece : pieces) arc.push_back(arc.back() + piece);
  return arc;
}

std::vector<double> nodal_lengths(const Points& X, const Boundary& boundary, int order) {
  std::unordered_map<int, double> share;
  for (const Chain& chain : boundary)
    for (std::size_t i = 0; i + order < chain.size(); i += order) {
      if (order == 1) {
        const double half = 0.5 * (X[chain[i + 1]] - X[chain[i]]).norm();
        share[chain[i]] += half;
        share[chain[i + 1]] += half;
      } else {
        const Eigen::Vector3d each = shares(edge_at(X, chain, i));
        for (int k = 0; k < 3; ++k) share[chain[i + k]] += each[k];
      }
    }
  std::vector<double> result;
  for (int node : nodes_of(boundary)) result.push_back(share.at(node));
  return result;
}

}  // namespace reye::mesh
