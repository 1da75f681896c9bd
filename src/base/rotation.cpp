#include "base/rotation.hpp"

#include <cmath>

namespace reye::base {

Mat3 cross_matrix(const Vec3& w) { return Mat3{{0.0, -w.z(), w.y()}, {w.z(), 0.0, -w.x()}, {-w.y(), w.x(), 0.0}}; }

Turn turn_by(const Vec3& theta) {
  const double angle = theta.norm();
  return angle > 0.0 ? Turn(Eigen::AngleAxisd(angle, theta / angle)) : Turn::Identity();
}

Vec3 rotation_vector(const Turn& turn) {
  const Eigen::AngleAxisd a(turn);
  return a.angle() * a.axis();
}

Mat3 turn_rate(const Vec3& theta) {
  const double q = theta.squaredNorm(), angle = std::sqrt(q);
  const Mat3 W = cross_matrix(theta);
  const bool small = angle < 1e-2;  // below it the series is exact to round-off, and the quotients lose digits
  const double a = small ? 0.5 - q / 24.0 + q * q / 720.0 : (1.0 - std::cos(angle)) / q;
  const double b = small ? 1.0 / 6.0 - q / 120.0 + q * q / 5040.0 : (angle - std::sin(angle)) / (q * angle);
  return Mat3::Identity() + a * W + b * W * W;
}

}  // namespace reye::base
