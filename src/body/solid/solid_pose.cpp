#include "body/solid/solid_pose.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace reye::body {

Vec3 SolidPose::pivot() const { return centre + shift; }

Vec3 SolidPose::place(const Vec3& X, const Vec3& w) const { return pivot() + R * (X + w - centre); }

Vec3 SolidPose::in_frame(const Vec3& X, const Vec3& x) const { return R.transpose() * (x - pivot()) + centre - X; }

Vec3 carried_along(const SolidPose& from, const SolidPose& to, const Vec3& x) {
  return to.pivot() + to.R * (from.R.transpose() * (x - from.pivot()));
}

Vec3 Twist::at(const Vec3& x) const { return turn.cross(x - origin) + way; }

Twist Twist::about(const Vec3& other) const { return {turn, at(other), other}; }

Twist relative_twist(const SolidPose& own_old, const SolidPose& own, const SolidPose& other_old,
                     const SolidPose& other) {
  const Mat3 own_turn = own.R * own_old.R.transpose(), other_turn = other.R * other_old.R.transpose();
  const Mat3 R = own_turn * other_turn.transpose();
  Twist twist;
  twist.turn = base::rotation_vector(base::Turn(R));
  twist.origin = own.pivot();
  const Vec3 moved = carried_along(own_old, own, carried_along(other, other_old, twist.origin));
  const Mat3 of_way = base::turn_rate(twist.turn).inverse();
  const Vec3 way = moved - twist.origin;
  twist.way = of_way * way;
  return twist;
}

namespace {

/// [a, b] of the exponential map on the left.
Twist bracket(const Twist& a, const Twist& b) {
  return {a.turn.cross(b.turn), a.turn.cross(b.way) + a.way.cross(b.turn), b.origin};
}

void add(Twist& sum, double factor, const Twist& part) {
  sum.turn += factor * part.turn;
  sum.way += factor * part.way;
}

}  // namespace

/// The inverse of the left Jacobian of exp, sum B_n / n! [twist, .]^n with Bernoulli's numbers: for turns of less than
/// half a turn the series leaves less than 1e-4 of the last term kept.
Twist change_of(const Twist& twist, const Twist& change) {
  Twist power = change.about(twist.origin), sum = power;
  constexpr double factors[] = {-0.5, 1.0 / 12.0, 0.0, -1.0 / 720.0, 0.0, 1.0 / 30240.0, 0.0, -1.0 / 1209600.0};
  for (const double factor : factors) {
    power = bracket(twist, power);
    add(sum, factor, power);
  }
  return sum;
}

}  // namespace reye::body
