#include "cad/part/plane.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace reye::cad {

namespace {

template <class Measure>
Vec3 farthest(const std::vector<Vec3>& points, Measure measure) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
}

}  // namespace

Plane plane_across(Vec3 normal) {
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
    if (std::abs(normal.dot(axis)) > 1.0 - 1e-14) normal = axis;
  if (normal.z() == 1.0) return {};
  if (std::abs(normal.z()) < 1e-9) {
    const Vec3 e2 = Vec3::UnitZ();
    Vec3 e1 = e2.cross(normal).normalized();
    if (e1.x() < -1e-9 || (e1.x() < 1e-9 && e1.y() < 0.0)) e1 = -e1;
    return {e1, e2};
  }
  if (normal.z() < 0.0) normal = -normal;
  const Vec3 along = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 e1 = (along - along.dot(normal) * normal).normalized();
  return {e1, normal.cross(e1)};
}

Plane plane_of(const std::vector<Vec3>& points) {
  if (points.empty()) throw base::MeshError("the face has no outline");
  const Vec3 origin = points.front();
  const Vec3 far = farthest(points, [&](const Vec3& p) { return (p - origin).squaredNorm(); }) - origin;
  const Vec3 wide = farthest(points, [&](const Vec3& p) { return far.cross(p - origin).squaredNorm(); }) - origin;
  const Vec3 normal = far.cross(wide);
  if (!(normal.norm() > 1e-12 * far.squaredNorm())) throw base::MeshError("the face has no area");
  return plane_across(normal.normalized());
}

}  // namespace reye::cad
