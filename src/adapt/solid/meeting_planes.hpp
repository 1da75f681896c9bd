#pragma once
#include <vector>

#include "base/space.hpp"

namespace reye::adapt {

using base::Vec3;

/// A vector over its length; along a coordinate axis exactly where it is so to round-off.
Vec3 unit_on_axis(const Vec3& v);

/// The tangent plane of a smooth part of the skin at a node: its outward unit normal, and the depth that it recedes by
/// [mm]. Zero: an unworn face, along which the node slides.
struct RecedingPlane {
  Vec3 normal = Vec3::Zero();
  double depth = 0.0;
};

/// The displacement d nearest to `along` for which planes of zero depth hold exactly, n . d = 0, and the others, n . d
/// = -depth, in the sense of least squares: exactly where up to three planes meet at angles. In a plane along a
/// coordinate axis, that coordinate stays to the last bit.   (README, 13)
Vec3 where_planes_meet(const std::vector<RecedingPlane>& planes, const Vec3& along = Vec3::Zero());

}  // namespace reye::adapt
