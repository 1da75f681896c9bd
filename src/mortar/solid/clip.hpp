#pragma once
#include <array>

#include "base/linalg.hpp"

namespace reye::mortar {

using base::Vec2;

/// A convex polygon of a plane, counter-clockwise. Two of four corners have at most eight in common.
struct ConvexPolygon {
  static constexpr int most = 8;
  std::array<Vec2, most> corners;
  int count = 0;
};

/// Area, from differences of corners [mm^2].
double polygon_area(const ConvexPolygon& polygon);

/// The mean of the corners, which lies inside.
Vec2 polygon_middle(const ConvexPolygon& polygon);

/// What two convex polygons have in common, one line of b after the other (Sutherland & Hodgman 1974). Corners within
/// `tolerance` [mm] of a line count as on it, so that coincident corners and shared edges make no slivers. What is
/// inside of a line is taken as one run of corners, which bounds the number of corners whatever the rounding. Of no
/// common area it has no corners. a and b together have at most eight corners.
ConvexPolygon overlap(const ConvexPolygon& a, const ConvexPolygon& b, double tolerance);

}  // namespace reye::mortar
