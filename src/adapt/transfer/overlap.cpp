#include "adapt/transfer/overlap.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace reye::adapt {

namespace {

using base::Points;
using base::Vec2;
using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;

/// A convex polygon, counter-clockwise, of a cell.
struct ConvexPart {
  int cell;
  double sign;
  Points polygon;
};

CGAL::Orientation turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return CGAL::orientation(ExactKernel::Point_2(a.x(), a.y()), {b.x(), b.y()}, {c.x(), c.y()});
}

/// The outline of a cell: its corners, and the mid nodes that are off the chord by more than round-off.
Points outline_of(const mesh::Mesh& mesh, const mesh::Cell& cell) {
  constexpr double straight = 1e-12;
  const int n = mesh::corners(mesh.kind);
  Points polygon;
  for (int k = 0; k < n; ++k) {
    const Vec2 &a = mesh.X[cell[k]], &b = mesh.X[cell[(k + 1) % n]];
    polygon.push_back(a);
    if (mesh::order(mesh.kind) == 1) continue;
    const Vec2& middle = mesh.X[cell[n + k]];
    if (std::abs(base::cross(b - a, middle - a)) > straight * (b - a).squaredNorm()) polygon.push_back(middle);
  }
  return polygon;
}

/// Every corner turns left.
bool convex(const Points& p) {
  for (std::size_t k = 0; k < p.size(); ++k)
    if (turn(p[k], p[(k + 1) % p.size()], p[(k + 2) % p.size()]) != CGAL::LEFT_TURN) return false;
  return true;
}

void add_parts(int cell, const Points& p, std::vector<ConvexPart>& parts) {
  if (convex(p)) {
    parts.push_back({cell, 1.0, p});
    return;
  }
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    const auto way = turn(p[0], p[k], p[k + 1]);
    if (way == CGAL::LEFT_TURN) parts.push_back({cell, 1.0, {p[0], p[k], p[k + 1]}});
    if (way == CGAL::RIGHT_TURN) parts.push_back({cell, -1.0, {p[0], p[k + 1], p[k]}});
  }
}

std::vector<ConvexPart> parts_of(const mesh::Mesh& mesh) {
  std::vector<ConvexPart> parts;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) add_parts(cell, outline_of(mesh, mesh.cells[cell]), parts);
  return parts;
}

std::vector<Box> boxes_of(const std::vector<ConvexPart>& parts) {
  std::vector<Box> boxes;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    CGAL::Bbox_2 box;
    for (const Vec2& x : parts[i].polygon) box += CGAL::Bbox_2(x.x(), x.y(), x.x(), x.y());
    boxes.emplace_back(box, i);
  }
  return boxes;
}

/// Where p -> q crosses the line a -> b, with p and q on different sides of it.
Vec2 crossing(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
  const double at_p = base::cross(b - a, p - a), at_q = base::cross(b - a, q - a);
  const double t = at_p != at_q ? std::clamp(at_p / (at_p - at_q), 0.0, 1.0) : 0.5;  // equal: both round-off
  return p + t * (q - p);
}

/// The part of a polygon left of a -> b.
Points left_of(const Vec2& a, const Vec2& b, const Points& polygon) {
  Points kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const auto at_p = turn(a, b, p), at_q = turn(a, b, q);
    if (at_p != CGAL::RIGHT_TURN) kept.push_back(p);
    if (at_p * at_q < 0) kept.push_back(crossing(a, b, p, q));
  }
  return kept;
}

/// Sutherland and Hodgman: the polygon is cut by one side of the convex window after the other.
Points common(Points polygon, const Points& window) {
  for (std::size_t k = 0; k < window.size() && polygon.size() > 2; ++k)
    polygon = left_of(window[k], window[(k + 1) % window.size()], polygon);
  return polygon;
}

}  // namespace

std::vector<Overlap> overlaps(const mesh::Mesh& from, const mesh::Mesh& to) {
  const auto old = parts_of(from), fresh = parts_of(to);
  auto old_boxes = boxes_of(old), fresh_boxes = boxes_of(fresh);
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_intersection_d(fresh_boxes.begin(), fresh_boxes.end(), old_boxes.begin(), old_boxes.end(),
                           [&](const Box& x, const Box& y) { pairs.emplace_back(x.info(), y.info()); });
  std::sort(pairs.begin(), pairs.end());  // sums over them must not depend on box order
  std::vector<Overlap> result;
  for (const auto& [i, j] : pairs) {
    auto polygon = common(old[j].polygon, fresh[i].polygon);
    if (polygon.size() > 2)
      result.push_back({fresh[i].cell, old[j].cell, fresh[i].sign * old[j].sign, std::move(polygon)});
  }
  return result;
}

}  // namespace reye::adapt
