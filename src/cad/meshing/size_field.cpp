#include "cad/meshing/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace reye::cad {

namespace {

/// Distance of p from the strip round one piece of a source's line. Beyond an end of the line the distances along and
/// across are treated separately, so that the strip ends square.
double distance_from_strip(const SizeSource& source, std::size_t piece, const Vec2& p) {
  const Vec2 &a = source.line[piece], &b = source.line[piece + 1];
  const double width = (b - a).norm();
  const Vec2 along = (b - a) / width;
  const double s = along.dot(p - a);
  const double over = std::max({0.0, -s, s - width});
  const bool at_end = (s < 0.0 && piece == 0) || (s > width && piece + 2 == source.line.size());
  const double across = base::cross(along, p - a);
  if (at_end) return std::hypot(over, std::max(0.0, std::abs(across) - source.depth));
  return std::max(0.0, std::hypot(over, across) - source.depth);
}

}  // namespace

SizeSource make_source(Points line, double depth, double size) {
  SizeSource source{std::move(line), depth, size, {}};
  source.box = {source.line[0].x(), source.line[0].y(), source.line[0].x(), source.line[0].y()};
  for (const Vec2& p : source.line)
    source.box = {std::min(source.box[0], p.x()), std::min(source.box[1], p.y()), std::max(source.box[2], p.x()),
                  std::max(source.box[3], p.y())};
  return source;
}

double SizeField::operator()(const Vec2& p) const {
  double size = far_;
  for (const SizeSource& source : sources_) {
    const auto& box = source.box;
    const double at_least =
        std::hypot(std::max({0.0, box[0] - p.x(), p.x() - box[2]}), std::max({0.0, box[1] - p.y(), p.y() - box[3]})) -
        source.depth;
    if (source.size + slope_ * at_least >= size) continue;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < source.line.size(); ++i)
      distance = std::min(distance, distance_from_strip(source, i, p));
    size = std::min(size, source.size + slope_ * distance);
  }
  return size;
}

double estimated_elements(double length, double depth, double size, double far_size, double growth) {
  double elements = length * depth / (size * size);
  const double slope = growth - 1.0;
  if (slope <= 0.0) return elements;
  for (double d = 0.0, h = size; h < far_size; d += h, h = size + slope * d)
    elements += (length + 2.0 * depth + std::numbers::pi * d) / h;  // one ring of elements of height h
  return elements;
}

}  // namespace reye::cad
