#include <gtest/gtest.h>

#include "body/solid/solid_pose.hpp"

using namespace reye;
using base::Mat3;
using base::Vec3;
using body::SolidPose;
using body::Twist;

namespace {

SolidPose pose_at(const Vec3& turn, const Vec3& centre, const Vec3& shift) {
  return {base::turn_by(turn).toRotationMatrix(), centre, shift};
}

/// A pose that has moved on by a small twist.
SolidPose moved_on(SolidPose pose, const Twist& twist, double step) {
  const Mat3 R = base::turn_by(step * twist.turn).toRotationMatrix();
  const Vec3 pivot = twist.origin + R * (pose.pivot() - twist.origin) + step * twist.way;
  pose.R = R * pose.R;
  pose.shift = pivot - pose.centre;
  return pose;
}

const SolidPose own_old = pose_at({0.3, -0.2, 0.9}, {1, 2, -1}, {0.2, 0.1, -0.3}),
                own = pose_at({0.5, -0.1, 1.0}, {1, 2, -1}, {0.3, 0.15, -0.2}),
                other_old = pose_at({-0.4, 1.2, 0.1}, {-2, 0.5, 1}, {0.0, 0.2, 0.1}),
                other = pose_at({-0.3, 1.3, 0.2}, {-2, 0.5, 1}, {0.1, 0.1, 0.1});

}  // namespace

TEST(SolidPoses, TurnRateIsTheDerivativeOfTheRotation) {
  // d exp(theta) = [T dtheta] x exp(theta), at large angles, at small ones and at none.
  for (const double size : {2.5, 0.3, 9.9e-3, 1e-6, 0.0}) {
    const Vec3 theta = size * Vec3(0.3, -0.5, 0.8).normalized(), d(0.2, 0.7, -0.4);
    const double h = 1e-6;
    const base::Turn change = base::turn_by(theta + h * d) * base::turn_by(theta - h * d).conjugate();
    EXPECT_LT((base::rotation_vector(change) / (2.0 * h) - base::turn_rate(theta) * d).norm(), 1e-9) << size;
  }
}

TEST(SolidPoses, BodiesThatMoveAsOneDoNotMovePastEachOther) {
  // A motion that carries two frames as one leaves no relative twist.
  const Twist together{{0.2, -0.25, 0.1}, {1, 2, 3}, {5, -4, 2}};
  const Twist twist =
      relative_twist(own_old, moved_on(own_old, together, 1.0), other_old, moved_on(other_old, together, 1.0));
  EXPECT_LT(twist.turn.norm(), 1e-15);
  EXPECT_LT(twist.at({3, 3, 3}).norm(), 1e-14);
}

TEST(SolidPoses, ATurnSlidesByItsArc) {
  // A frame that turns about its centre slides at each place by angle times radius, whatever the angle.
  const Vec3 axis = Vec3(1, 2, -2).normalized(), centre(1, 0, 0);
  const Twist twist = relative_twist(pose_at(0.4 * axis, centre, Vec3::Zero()),
                                     pose_at(2.9 * axis, centre, Vec3::Zero()), SolidPose{}, SolidPose{});
  const Vec3 x = centre + 3.0 * axis.unitOrthogonal() + 7.0 * axis;
  EXPECT_NEAR(twist.at(x).norm(), 2.5 * 3.0, 1e-13);
  EXPECT_NEAR(twist.at(x).dot(x - centre), 0.0, 1e-13);
}

TEST(SolidPoses, TheTwistLeadsFromTheOldPlaceToTheNew) {
  // What rests in the other frame is carried by the screw of the twist to where the own frame carries it.
  const Twist twist = relative_twist(own_old, own, other_old, other);
  const Vec3 x(2, -1, 0.5);
  Vec3 y = x;
  for (int k = 0; k < 200000; ++k) y += twist.at(y + 0.5 * twist.at(y) / 200000.0) / 200000.0;
  const Vec3 exact = body::carried_along(own_old, own, body::carried_along(other, other_old, x));
  EXPECT_LT((y - exact).norm(), 1e-9);
}

TEST(SolidPoses, ChangeOfATwistIsItsDerivative) {
  // The twist changes with either frame as central differences say.
  const Twist change{{0.3, 0.4, -0.7}, {0.5, -0.2, 0.9}, {0.1, 0.2, 0.3}};
  const Twist twist = relative_twist(own_old, own, other_old, other);
  const double h = 1e-5;
  const Vec3 x(2, -1, 0.5);
  const auto slope = [&](const Twist& ahead, const Twist& behind) {
    return Vec3((ahead.at(x) - behind.at(x)) / (2 * h));
  };
  const Vec3 by_own = slope(relative_twist(own_old, moved_on(own, change, h), other_old, other),
                            relative_twist(own_old, moved_on(own, change, -h), other_old, other));
  EXPECT_LT((change_of(twist, change).at(x) - by_own).norm(), 1e-9);
  const Vec3 by_other = slope(relative_twist(own_old, own, other_old, moved_on(other, change, h)),
                              relative_twist(own_old, own, other_old, moved_on(other, change, -h)));
  const Twist reversed{-twist.turn, -twist.way, twist.origin};
  EXPECT_LT((change_of(reversed, change).at(x) + by_other).norm(), 1e-9);
}
