#pragma once
#include <span>

#include "solver/solid/turning_motion.hpp"

namespace reye::solver {

/// Free motions of bodies that turn with which a Newton iteration begins: those that carry each body along with what it
/// touched, so that closed points stay closed and sticking ones stay in place, in the sense of least squares. `moved`:
/// displacements of the points in which only what is driven has moved on from `old`; `poses` likewise. `places` of the
/// contacts at `old`.
Vector carried_along_motions(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                             const std::vector<body::SolidPose>& poses, const Vector& moved,
                             std::span<const contact::SkinPlace> places);

}  // namespace reye::solver
