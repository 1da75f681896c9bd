#include "adapt/shape/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reye::adapt {

namespace {

constexpr double widest = std::numbers::pi / 6.0;  ///< between a tangent and its chords

double angle_between(const Vec2& a, const Vec2& b) { return std::atan2(base::cross(a, b), a.dot(b)); }

Vec2 turned(const Vec2& v, double angle) {
  return {std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}

Vec2 mirrored(const Vec2& v, const Vec2& axis) { return 2.0 * axis.dot(v) * axis - v; }

/// Tangent at b between the chords a -> b and b -> c.
Vec2 middle_tangent(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 in = b - a, out = c - b;
  const double turn = angle_between(in, out), size = std::abs(turn);
  const double part = std::abs(angle_between(in, in / in.squaredNorm() + out / out.squaredNorm()));
  const double kept = size > 2.0 * widest ? 0.5 * size : std::clamp(part, size - widest, widest);
  return turned(in.normalized(), std::copysign(kept, turn));
}

/// Curvature of the circle through three points.
double curvature(const Vec2& a, const Vec2& b, const Vec2& c) {
  return 2.0 * base::cross(b - a, c - b) / ((b - a).norm() * (c - b).norm() * (c - a).norm());
}

}  // namespace

Points smooth_tangents(const Points& p, bool closed) {
  const std::size_t n = p.size();
  if (n == 2) return {(p[1] - p[0]).normalized(), (p[1] - p[0]).normalized()};
  Points t(n);
  for (std::size_t i = 1; i + 1 < n; ++i) t[i] = middle_tangent(p[i - 1], p[i], p[i + 1]);
  if (closed) {
    t.front() = t.back() = middle_tangent(p[n - 2], p[0], p[1]);
  } else {
    t.front() = mirrored(t[1], (p[1] - p[0]).normalized());
    t.back() = mirrored(t[n - 2], (p[n - 1] - p[n - 2]).normalized());
  }
  return t;
}

double fit_error(const Points& p, bool closed) {
  const std::size_t n = p.size();
  if (n < 4) return 0.0;
  std::vector<double> kappa(n);
  for (std::size_t i = 1; i + 1 < n; ++i) kappa[i] = curvature(p[i - 1], p[i], p[i + 1]);
  kappa.front() = closed ? curvature(p[n - 2], p[0], p[1]) : kappa[1];
  kappa.back() = closed ? kappa.front() : kappa[n - 2];
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < n; ++i)
    largest = std::max(largest, std::abs(kappa[i + 1] - kappa[i]) * (p[i + 1] - p[i]).squaredNorm() / 8.0);
  return largest;
}

cad::Edge fit(cad::EdgeType type, Points points, double tolerance) {
  const bool closed = points.size() > 3 && points.front() == points.back();
  if (!(fit_error(points, closed) <= tolerance)) return cad::make_polyline(type, std::move(points));
  Points tangents = smooth_tangents(points, closed);
  return cad::make_edge(type, std::move(points), std::move(tangents));
}

}  // namespace reye::adapt
