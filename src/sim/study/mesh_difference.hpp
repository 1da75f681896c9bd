#pragma once
#include <optional>
#include <string>

#include "sim/problem/records.hpp"

/// What two runs on different meshes say of the error of either.
namespace reye::sim {

/// Differences between the ends of a run on two meshes, the largest of all contacts; a point of one mesh is compared
/// with the nearest one of the other.
struct MeshDifference {
  /// For sides that have worn: int |w - w'| over int w, and the difference of the largest depths over the largest
  /// depth.
  std::optional<double> wear;
  /// For secondary sides that touch, t = (p, q): root of int |t - t'|^2 over int |t|^2.
  std::optional<double> traction;
  /// For secondary sides that touch: the difference of the largest pressures over the largest pressure.
  std::optional<double> peak;
};

/// The estimated errors of the mesh, both relative.
struct DiscretisationError {
  RunStatus companion = RunStatus::done;  ///< how the run on longer elements ended
  std::string reason;                     ///< why there is no error of the surface; empty when there is
  std::optional<double> surface;          ///< of depths, or of tractions where nothing wears
  std::optional<double> peak_pressure;    ///< of the largest pressure at the end
  std::optional<double> energy_norm;      ///< of the stress in linear bodies, by recovery (`fem::recovered_error`)
  double order = 0.0;                     ///< power of the element size that `surface` falls with
};

/// The error of the surface and of the peak pressure that these differences leave. `stick_edge`: loaded places stick
/// beside others that slide.
void add_errors(const MeshDifference& apart, bool stick_edge, DiscretisationError& error);

/// The error in words.
std::string in_words(const DiscretisationError& error);

}  // namespace reye::sim
