#include "mesh/measure.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "mesh/outline.hpp"

namespace reye::mesh {

namespace {

bool before(const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); }

/// The end of a chain from which its arc length counts.
Vec2 origin(const Points& X, const Chain& chain) {
  const Vec2 first = X[chain.front()], last = X[chain.back()];
  return before(last, first) ? last : first;
}

}  // namespace

double enclosed_area(const Points& X, const Chain& loop) {
  double twice = 0.0;
  const Vec2 shift = X[loop.front()];  // near the loop: no digits lost far from the origin
  for (std::size_t i = 0; i + 1 < loop.size(); ++i) twice += base::cross(X[loop[i]] - shift, X[loop[i + 1]] - shift);
  return 0.5 * twice;
}

double cell_area(const Points& X, CellKind kind, const Cell& cell) {
  if (kind == CellKind::tri3) return 0.5 * base::cross(X[cell[1]] - X[cell[0]], X[cell[2]] - X[cell[0]]);
  return 0.5 * base::cross(X[cell[2]] - X[cell[0]], X[cell[3]] - X[cell[1]]);
}

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const Cell& cell : mesh.cells) sum += cell_area(mesh.X, mesh.kind, cell);
  if (mesh.cells.empty())
    for (const Chain& loop : mesh.outline) sum += enclosed_area(mesh.X, loop);
  return sum;
}

std::array<double, 4> bounding_box(const Points& X) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 4> box{infinity, infinity, -infinity, -infinity};
  for (const Vec2& p : X)
    box = {std::min(box[0], p.x()), std::min(box[1], p.y()), std::max(box[2], p.x()), std::max(box[3], p.y())};
  return box;
}

double length(const Points& X, const Chain& chain) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) sum += (X[chain[i + 1]] - X[chain[i]]).norm();
  return sum;
}

double length(const Points& X, const Boundary& boundary) {
  return std::accumulate(boundary.begin(), boundary.end(), 0.0,
                         [&](double sum, const Chain& chain) { return sum + length(X, chain); });
}

Vec2 outward_normal(const Vec2& a, const Vec2& b) { return base::right_of(b - a).normalized(); }

std::vector<double> arc_lengths(const Points& X, const Chain& chain) {
  std::vector<double> arc(chain.size(), 0.0);
  if (is_closed(chain) || !before(X[chain.back()], X[chain.front()])) {
    for (std::size_t i = 1; i < chain.size(); ++i) arc[i] = arc[i - 1] + (X[chain[i]] - X[chain[i - 1]]).norm();
  } else {
    for (std::size_t i = chain.size() - 1; i-- > 0;) arc[i] = arc[i + 1] + (X[chain[i + 1]] - X[chain[i]]).norm();
  }
  return arc;
}

std::vector<double> arc_lengths(const Points& X, const Boundary& boundary) {
  std::vector<std::size_t> order(boundary.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return before(origin(X, boundary[a]), origin(X, boundary[b]));
  });
  std::unordered_map<int, double> at;
  double start = 0.0;
  for (std::size_t k : order) {
    const std::vector<double> arc = arc_lengths(X, boundary[k]);
    for (std::size_t i = 0; i < arc.size(); ++i) at.insert({boundary[k][i], start + arc[i]});
    start += length(X, boundary[k]);
  }
  std::vector<double> result;
  for (int node : nodes_of(boundary)) result.push_back(at.at(node));
  return result;
}

std::vector<double> nodal_lengths(const Points& X, const Boundary& boundary) {
  std::unordered_map<int, double> share;
  for (const Chain& chain : boundary)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const double half = 0.5 * (X[chain[i + 1]] - X[chain[i]]).norm();
      share[chain[i]] += half;
      share[chain[i + 1]] += half;
    }
  std::vector<double> result;
  for (int node : nodes_of(boundary)) result.push_back(share.at(node));
  return result;
}

}  // namespace reye::mesh
