#pragma once
#include <cmath>

/// What is known of how errors of contact and wear fall with the element size.
namespace reye::sim {

/// Elements of a companion run over those of the run.
inline constexpr double coarsening = 2.0;

/// Powers of the element size that the errors fall with: tractions have a root at the edge of contact, worn profiles
/// are smooth but for a corner at the end (measured in `results/time_against_error`, `results/mesh_error`); with an
/// edge of stick, which is found to one node, their error falls with it (`results/partial_slip_life`).
inline constexpr double traction_order = 1.0, wear_order = 2.0, stick_order = 1.0;

/// Error on the mesh h over the difference between h and 2 h: 1 / (2^p - 1) where both errors have the same shape,
/// 1 / sqrt(4^p + 1) where they are independent, since an edge of contact lies anywhere in its element. The
/// geometric mean of the two is off by at most sqrt(5^(1/2)) = 1.5 (p = 1) or sqrt(17^(1/2) / 3) = 1.2 (p = 2).
inline double left_of_difference(double order) {
  const double apart = std::pow(coarsening, order);
  return 1.0 / std::sqrt((apart - 1.0) * std::sqrt(apart * apart + 1.0));
}

}  // namespace reye::sim
