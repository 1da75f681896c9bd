#pragma once
#include "base/rotation.hpp"

/// Where the frame of a solid that turns is, and how two frames move past each other.      [README (15), (18)]
namespace reye::body {

using base::Mat3;
using base::Vec3;

/// x = c + t + R (X + w - c), w the displacement in the frame.
struct SolidPose {
  Mat3 R = Mat3::Identity();
  Vec3 centre = Vec3::Zero();  ///< c
  Vec3 shift = Vec3::Zero();   ///< t

  Vec3 pivot() const;
  Vec3 place(const Vec3& X, const Vec3& w) const;
  Vec3 in_frame(const Vec3& X, const Vec3& x) const;  ///< w of a place x
};

/// Where what is at x now would be if it had stayed in its frame from one pose to another.
Vec3 carried_along(const SolidPose& from, const SolidPose& to, const Vec3& x);

/// A velocity field times a time, v(x) = turn x (x - origin) + way.
struct Twist {
  Vec3 turn = Vec3::Zero(), way = Vec3::Zero(), origin = Vec3::Zero();

  Vec3 at(const Vec3& x) const;
  Twist about(const Vec3& other) const;
};

/// The steady motion (a screw) by which a frame moves past another one while both go from their old poses to their new
/// ones, seen from the other, at the places where they end. It is zero where both move as one, and an arc keeps its
/// length.
Twist relative_twist(const SolidPose& own_old, const SolidPose& own, const SolidPose& other_old,
                     const SolidPose& other);

/// The change of a relative twist as the frame itself moves on by `change`, about the origin of the twist. The other
/// frame's motion changes it by minus that of the twist reversed.
Twist change_of(const Twist& twist, const Twist& change);

}  // namespace reye::body
