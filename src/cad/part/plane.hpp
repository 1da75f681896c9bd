#pragma once
#include <optional>
#include <vector>

#include "cad/part/part.hpp"
#include "cad/part/raw.hpp"

namespace reye::cad {

/// Axes of the plane that becomes x-y: a point p goes to (p . e1, p . e2).
/// A plane z = const keeps x and y. Else the normal is taken with positive z (seen from above, not mirrored), e1 is the
/// global x axis laid into the plane (the y axis if the plane stands across x), e2 = normal x e1; in a
/// vertical plane e2 is the global z axis.
struct Plane {
  Vec3 e1 = Vec3::UnitX();
  Vec3 e2 = Vec3::UnitY();

  Vec2 map(const Vec3& p) const { return {p.dot(e1), p.dot(e2)}; }
};

/// The plane across a unit normal.
Plane plane_across(Vec3 normal);

/// The plane of the points. Throws base::MeshError when they lie on one line.
Plane plane_of(const std::vector<Vec3>& points);

}  // namespace reye::cad
