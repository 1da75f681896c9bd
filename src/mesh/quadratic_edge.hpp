#pragma once

#include "base/linalg.hpp"

namespace reye::mesh {

using base::Vec2;

/// An edge of second order, x(xi) = mid + xi p + xi^2/2 q with p = (last - first)/2, q = first + last - 2 mid,
/// xi from -1 (first) to 1 (last).
struct QuadraticEdge {
  Vec2 first, mid, last;

  Vec2 at(double xi) const;
  Vec2 tangent(double xi) const;  ///< dx / dxi

  /// N of first, mid and last node.
  static Eigen::Vector3d shape(double xi) { return {0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)}; }

  /// Unit normal at xi, the body on the left.
  Vec2 outward_normal(double xi) const { return base::right_of(tangent(xi)).normalized(); }

  /// Length between two parameters [mm], in closed form; negative when `from` > `to`.
  double length(double from = -1.0, double to = 1.0) const;

  /// The parameter at which the length from `first` on is s, clamped to [-1, 1].
  double parameter_at(double s) const;

  /// Area between the edge and its chord [mm^2], positive where the edge bulges outwards: 2/3 (mid - first) x chord.
  double segment_area() const { return 2.0 / 3.0 * base::cross(mid - first, last - first); }
};

}  // namespace reye::mesh
