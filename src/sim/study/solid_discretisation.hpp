#pragma once
#include <vector>

#include "sim/solid/solid_observer.hpp"
#include "sim/study/mesh_difference.hpp"

/// The error of a run of solids against the limit of an infinitely fine mesh; in the plane: `discretisation`.
namespace reye::sim {

/// The scene of `problem` with elements twice as long, played as far as `state` has come, without limits.
scene::SolidScene coarser(const SolidProblem& problem, const SolidRunState& state);

/// Differences between the ends of a run on two meshes of the same sides: each row of `fine` is compared with the
/// nearest place of `coarse`.
MeshDifference mesh_difference(const std::vector<SkinRecord>& fine, const std::vector<SkinRecord>& coarse);

/// Plays the companion run and compares the surfaces at the end, by wear where anything wears, else by tractions.
DiscretisationError mesh_error(const SolidProblem& problem, const SolidRunState& state, const SolidObserver& observer);

}  // namespace reye::sim
