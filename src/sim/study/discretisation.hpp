#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"
#include "sim/study/mesh_difference.hpp"

/// The error of a run against the limit of an infinitely fine mesh.
namespace reye::sim {

/// The scene of `problem` on elements twice as long, played as far as `state` has come, without output and limits, with
/// the kinematics of the run. Fine zones are wider by the margins that longer elements need at their ends
/// (`leaves_zone`).
scene::Scene coarser(const Problem& problem, const State& state);

MeshDifference mesh_difference(const std::vector<SurfaceRecord>& fine, const std::vector<SurfaceRecord>& coarse,
                               base::Analysis analysis);

/// Plays the companion run and compares the surfaces at the end, by wear where anything wears, else by tractions. The
/// errors of the two fall with powers of the element size that are known, so that their difference gives the error that
/// is left.
DiscretisationError mesh_error(const Problem& problem, const State& state, Cache& cache, const Observer& observer);

}  // namespace reye::sim
