#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "mortar/solid/clip.hpp"

/// Random pairs of convex polygons, and their common area by another algorithm.
namespace reye::test {

using base::Vec2;
using mortar::ConvexPolygon;

/// Where lines x = const cut a convex polygon: the lower and the upper end.
struct Chord {
  long double lo = 1e30L, hi = -1e30L;
};

inline Chord chord(const ConvexPolygon& p, long double x) {
  Chord c;
  for (int i = 0; i < p.count; ++i) {
    const Vec2 &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
    const long double ax = a.x(), ay = a.y(), bx = b.x(), by = b.y();
    if ((ax < x && bx < x) || (ax > x && bx > x) || ax == bx) continue;
    const long double y = ay + (by - ay) * ((x - ax) / (bx - ax));
    c.lo = std::min(c.lo, y);
    c.hi = std::max(c.hi, y);
  }
  return c;
}

/// Adds the x at which an edge of p crosses one of q.
inline void add_crossings(const ConvexPolygon& p, const ConvexPolygon& q, std::vector<long double>& cuts) {
  for (int i = 0; i < p.count; ++i)
    for (int k = 0; k < q.count; ++k) {
      const Vec2 &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
      const Vec2 &c = q.corners[k], &d = q.corners[(k + 1) % q.count];
      const long double ux = (long double)b.x() - a.x(), uy = (long double)b.y() - a.y();
      const long double vx = (long double)d.x() - c.x(), vy = (long double)d.y() - c.y();
      const long double det = ux * vy - uy * vx;
      if (det == 0.0L) continue;
      const long double t = (((long double)c.x() - a.x()) * vy - ((long double)c.y() - a.y()) * vx) / det;
      if (t > 0.0L && t < 1.0L) cuts.push_back(a.x() + t * ux);
    }
}

/// Common area of two convex polygons: between neighbouring abscissae of corners and crossings the common height is
/// linear.
inline double area_by_slabs(const ConvexPolygon& p, const ConvexPolygon& q) {
  std::vector<long double> cuts;
  for (int i = 0; i < p.count; ++i) cuts.push_back(p.corners[i].x());
  for (int i = 0; i < q.count; ++i) cuts.push_back(q.corners[i].x());
  add_crossings(p, q, cuts);
  std::sort(cuts.begin(), cuts.end());
  long double area = 0.0L;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const long double middle = 0.5L * (cuts[i - 1] + cuts[i]);
    const auto a = chord(p, middle), b = chord(q, middle);
    area += (cuts[i] - cuts[i - 1]) * std::max(0.0L, std::min(a.hi, b.hi) - std::max(a.lo, b.lo));
  }
  return static_cast<double>(area);
}

/// A random triangle or convex quadrangle; every third one is a sliver. Corners may stand on a coarse grid, so that
/// corners and edges of two polygons coincide.
class RandomPolygons {
 public:
  explicit RandomPolygons(unsigned seed) : random_(seed) {}

  ConvexPolygon one() {
    for (;;) {
      const ConvexPolygon p = number_(random_) < 0.5 ? triangle() : quadrangle();
      if (p.count > 0) return p;
    }
  }

  /// A second polygon that shares corners, an edge or nothing with the first one, or is the same.
  ConvexPolygon beside(const ConvexPolygon& p) {
    const double kind = number_(random_);
    if (kind < 0.5) return one();
    if (kind < 0.55) return p;
    for (;;) {
      const int i = static_cast<int>(number_(random_) * p.count) % p.count;
      const Vec2 a = p.corners[i], b = p.corners[(i + 1) % p.count];
      ConvexPolygon q;
      q.count = 3;
      if (kind < 0.7) q.corners = {b, a, point()};  // a shared edge, on the other side or on the same
      if (kind >= 0.7 && kind < 0.85) q.corners = {a, point(), point()};  // a shared corner
      if (kind >= 0.85) q.corners = {Vec2(a + number_(random_) * (b - a)), Vec2(b + 1e-15 * point()), point()};
      if (counter_clockwise(q)) return q;
    }
  }

 private:
  static constexpr double least_area = 1e-9;

  Vec2 point() {
    if (coarse_) return {std::floor(5 * number_(random_)) / 4, std::floor(5 * number_(random_)) / 4};
    return {number_(random_), number_(random_)};
  }

  bool counter_clockwise(ConvexPolygon& p) {
    if (mortar::polygon_area(p) < 0.0) std::swap(p.corners[1], p.corners[2]);
    return mortar::polygon_area(p) > least_area;
  }

  ConvexPolygon triangle() {
    coarse_ = number_(random_) < 0.3;
    ConvexPolygon p;
    p.count = 3;
    p.corners = {point(), point(), point()};
    if (number_(random_) < 0.33) {
      const double at = number_(random_);
      p.corners[2] = p.corners[0] + at * (p.corners[1] - p.corners[0]) + 1e-7 * point();
    }
    if (!counter_clockwise(p)) p.count = 0;
    return p;
  }

  ConvexPolygon quadrangle() {
    coarse_ = number_(random_) < 0.3;
    ConvexPolygon p;
    p.count = 4;
    p.corners = {point(), point(), point(), point()};
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 &a = p.corners[i], &b = p.corners[(i + 1) % 4], &c = p.corners[(i + 2) % 4];
      if (base::cross(b - a, c - b) <= least_area) p.count = 0;
    }
    return p;
  }

  std::mt19937_64 random_;
  std::uniform_real_distribution<double> number_{0.0, 1.0};
  bool coarse_ = false;
};

/// The larger side of a polygon's box.
inline double polygon_size(const ConvexPolygon& p) {
  Vec2 lo = p.corners[0], hi = lo;
  for (int i = 1; i < p.count; ++i) {
    lo = lo.cwiseMin(p.corners[i]);
    hi = hi.cwiseMax(p.corners[i]);
  }
  return (hi - lo).maxCoeff();
}

/// Largest error of the common area of random pairs: relative to the larger facet's area, and to the square of its
/// size.
struct ClipErrors {
  double of_area = 0.0, of_size = 0.0;
  int meeting = 0;
  bool valid = true;  ///< corners finite, their number bounded, the polygon counter-clockwise
};

inline ClipErrors clip_errors(int pairs, unsigned seed) {
  RandomPolygons random(seed);
  ClipErrors errors;
  for (int i = 0; i < pairs; ++i) {
    const auto a = random.one(), b = random.beside(a);
    const double size = std::max(polygon_size(a), polygon_size(b));
    const auto common = mortar::overlap(a, b, 1e-14 * polygon_size(a));
    for (int k = 0; k < common.count; ++k) errors.valid = errors.valid && common.corners[k].allFinite();
    errors.valid = errors.valid && common.count <= ConvexPolygon::most && mortar::polygon_area(common) >= -1e-16;
    const double error = std::abs(mortar::polygon_area(common) - area_by_slabs(a, b));
    if (common.count > 0) ++errors.meeting;
    const double area = std::max(mortar::polygon_area(a), mortar::polygon_area(b));
    if (area > 1e-3 * size * size) errors.of_area = std::max(errors.of_area, error / area);
    errors.of_size = std::max(errors.of_size, error / (size * size));
  }
  return errors;
}

}  // namespace reye::test
