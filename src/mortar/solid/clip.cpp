#include "mortar/solid/clip.hpp"

namespace reye::mortar {

namespace {

/// Adds a corner that does not coincide with the last one.
void add_corner(ConvexPolygon& polygon, const Vec2& x, double tolerance) {
  if (polygon.count > 0 && (x - polygon.corners[polygon.count - 1]).squaredNorm() <= tolerance * tolerance) return;
  if (polygon.count < ConvexPolygon::most) polygon.corners[polygon.count++] = x;
}

/// Signed distances of the corners from a line, positive on its left, and the two extremes.
struct Distances {
  std::array<double, ConvexPolygon::most> d;
  int farthest = 0;
  double lowest = 0.0;
};

Distances distances(const ConvexPolygon& p, const Vec2& a, const Vec2& direction) {
  Distances result;
  for (int i = 0; i < p.count; ++i) {
    result.d[i] = base::cross(direction, p.corners[i] - a);
    if (result.d[i] > result.d[result.farthest]) result.farthest = i;
    if (i == 0 || result.d[i] < result.lowest) result.lowest = result.d[i];
  }
  return result;
}

/// The part on the left of the line from a to b.
void keep_left(ConvexPolygon& p, const Vec2& a, const Vec2& b, double tolerance) {
  const double length = (b - a).norm();
  if (length <= tolerance) return;
  const auto [d, farthest, lowest] = distances(p, a, (b - a) / length);
  if (lowest >= -tolerance) return;
  ConvexPolygon left;
  if (d[farthest] > tolerance) {
    const auto crossing = [&](int in, int out) {
      return Vec2(p.corners[in] + d[in] / (d[in] - d[out]) * (p.corners[out] - p.corners[in]));
    };
    int first = farthest, before = (first + p.count - 1) % p.count;
    while (d[before] >= 0.0) first = before, before = (first + p.count - 1) % p.count;
    add_corner(left, crossing(first, before), tolerance);
    int last = first;
    for (; d[last] >= 0.0; last = (last + 1) % p.count) add_corner(left, p.corners[last], tolerance);
    add_corner(left, crossing((last + p.count - 1) % p.count, last), tolerance);
  }
  p = left;
}

}  // namespace

double polygon_area(const ConvexPolygon& p) {
  double twice = 0.0;
  for (int i = 2; i < p.count; ++i) twice += base::cross(p.corners[i - 1] - p.corners[0], p.corners[i] - p.corners[0]);
  return 0.5 * twice;
}

Vec2 polygon_middle(const ConvexPolygon& p) {
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < p.count; ++i) sum += p.corners[i];
  return sum / p.count;
}

ConvexPolygon overlap(const ConvexPolygon& a, const ConvexPolygon& b, double tolerance) {
  ConvexPolygon common = a;
  for (int i = 0; i < b.count && common.count > 2; ++i)
    keep_left(common, b.corners[i], b.corners[(i + 1) % b.count], tolerance);
  if (common.count < 3) common.count = 0;
  return common;
}

}  // namespace reye::mortar
