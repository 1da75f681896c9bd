#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

/// The error of a run against the limit of an infinitely fine mesh.
namespace reye::sim {

/// The scene of `problem` on elements twice as long, played as far as `state` has come, without output and limits, with
/// the kinematics of the run. Fine zones are wider by the margins that longer elements need at their ends
/// (`leaves_zone`).
scene::Scene coarser(const Problem& problem, const State& state);

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

MeshDifference mesh_difference(const std::vector<SurfaceRecord>& fine, const std::vector<SurfaceRecord>& coarse,
                               base::Analysis analysis);

/// The estimated errors of the mesh, both relative.
struct DiscretisationError {
  RunStatus companion = RunStatus::done;  ///< how the run on longer elements ended
  std::string reason;                     ///< why there is no error of the surface; empty when there is
  std::optional<double> surface;          ///< of depths, or of tractions where nothing wears
  std::optional<double> peak_pressure;    ///< of the largest pressure at the end
  std::optional<double> energy_norm;      ///< of the stress in linear bodies, by recovery (`fem::recovered_error`)
  double order = 0.0;                     ///< power of the element size that `surface` falls with
};

/// Plays the companion run and compares the surfaces at the end, by wear where anything wears, else by tractions. The
/// errors of the two fall with powers of the element size that are known, so that their difference gives the error that
/// is left.
DiscretisationError mesh_error(const Problem& problem, const State& state, Cache& cache, const Observer& observer);

}  // namespace reye::sim
