#include "cad/solid/triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace reye::cad {

namespace {

using base::Vec3;

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  const double s = length > 0.0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0.0;
  return a + s * along;
}

Vec3 nearest_on_triangle(const Triangle& t, const Vec3& p) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double twice = normal.squaredNorm();
  bool above = twice > 0.0;
  for (int k = 0; k < 3 && above; ++k) above = (t[(k + 1) % 3] - t[k]).cross(p - t[k]).dot(normal) >= 0.0;
  if (above) return p - normal.dot(p - t[0]) / twice * normal;
  Vec3 best = nearest_on_segment(t[2], t[0], p);
  for (int k = 0; k < 2; ++k) {
    const Vec3 other = nearest_on_segment(t[k], t[k + 1], p);
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  }
  return best;
}

/// Van Oosterom & Strackee, The solid angle of a plane triangle, IEEE Trans. Biomed. Eng. 30 (1983).
double solid_angle(const Triangle& t, const Vec3& p) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

double area_of(const std::vector<Triangle>& surface) {
  double twice = 0.0;
  for (const Triangle& t : surface) twice += (t[1] - t[0]).cross(t[2] - t[0]).norm();
  return 0.5 * twice;
}

double winding_number(const std::vector<Triangle>& surface, const Vec3& p) {
  double angle = 0.0;
  for (const Triangle& t : surface) angle += solid_angle(t, p);
  return angle / (4.0 * std::numbers::pi);
}

Vec3 nearest_on(const std::vector<Triangle>& surface, const Vec3& p) {
  Vec3 best = surface.front()[0];
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : surface) {
    const Vec3 q = nearest_on_triangle(t, p);
    const double distance = (q - p).squaredNorm();
    if (distance < least) best = q, least = distance;
  }
  return best;
}

}  // namespace reye::cad
