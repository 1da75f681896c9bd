#pragma once
#include <numbers>

namespace reye::base {

/// The two-dimensional idealisation. Axisymmetric: r = x >= 0, axis y; integrals carry 2 pi r.
enum class Analysis { plane_strain, plane_stress, axisymmetric };

/// Weight of the out-of-plane direction at x: 1 (per mm of thickness) or 2 pi x (whole circumference).
template <class T>
T out_of_plane(Analysis analysis, const T& x) {
  return analysis == Analysis::axisymmetric ? T(2.0 * std::numbers::pi * x) : T(1.0);
}

/// Strain measure of a body. Also the measure of a contact whose secondary body it is: length on X (small), on x
/// (finite).
enum class Kinematics { small, finite };

}  // namespace reye::base
