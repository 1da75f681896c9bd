#pragma once
#include <Eigen/Geometry>

#include "base/space.hpp"

/// Rotations of space by any angle, as rotation vectors (axis times angle), quaternions and matrices.
namespace reye::base {

using Turn = Eigen::Quaterniond;

/// The matrix of v -> w x v.
Mat3 cross_matrix(const Vec3& w);

/// exp(theta): the rotation by |theta| about theta.
Turn turn_by(const Vec3& theta);

/// The rotation vector of a rotation, at most half a turn.
Vec3 rotation_vector(const Turn& turn);

/// T(theta) of d exp(theta) = [T dtheta] x exp(theta): the mean of exp(s theta) over s in [0, 1].
Mat3 turn_rate(const Vec3& theta);

}  // namespace reye::base
