#pragma once
#include <Eigen/Core>
#include <vector>

/// Vectors of three-dimensional space.
namespace reye::base {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Points3 = std::vector<Vec3>;

}  // namespace reye::base
