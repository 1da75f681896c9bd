#pragma once
#include "base/space.hpp"
#include "output/picture/canvas.hpp"

namespace reye::output {

using base::Points3;
using base::Vec3;

/// A view of space along parallel lines, onto a field of a picture in pixels (y downwards).
struct SpaceView {
  Vec3 right, up, toward;  ///< unit, orthogonal, right-handed; `toward` points to the viewer
  Box field;
  double pixels_per_mm = 1.0;
  Vec2 seen_mid{0.0, 0.0};  ///< place in the middle of the field, along `right` and `up` [mm]

  Vec2 pixel(const Vec3& x) const;
  /// Grows towards the viewer [mm].
  double nearness(const Vec3& x) const { return toward.dot(x); }
  /// A direction in the picture, in pixels per mm.
  Vec2 along(const Vec3& direction) const {
    return {pixels_per_mm * right.dot(direction), -pixels_per_mm * up.dot(direction)};
  }
};

/// The view from a side that shows some points as large as the field takes; `above`: what points upwards in it.
SpaceView space_view(const Vec3& toward, const Vec3& above, const Box& field, const Points3& shown);

}  // namespace reye::output
