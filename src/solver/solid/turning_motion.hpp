#pragma once
#include <vector>

#include "solver/solid/increment_state.hpp"

/// Slip and tangent where bodies turn.                                                             [README (S2), (S3)]
namespace reye::solver {

/// Where bodies stand at the beginning of an increment and now.
struct Standing {
  Vector x_old, x;                                ///< places of the points
  std::vector<body::SolidPose> old_poses, poses;  ///< per body
  /// Per contact and body: how the body's frame moves past that of the secondary body; empty where no body of the
  /// contact turns.
  std::vector<std::vector<body::Twist>> twist;
};

/// The relative twists of all contacts between two sets of poses.
std::vector<std::vector<body::Twist>> relative_twists(const SolidSystem& system,
                                                      const std::vector<body::SolidPose>& old_poses,
                                                      const std::vector<body::SolidPose>& poses);

/// The motion of all points over the increment as the secondary body of a contact sees it: what its deformation, and
/// the relative twist of the others, adds to a motion of all as one. `contact`: one with a twist.
Vector seen_motion(const SolidSystem& system, const Standing& standing, std::size_t contact);

/// Displacements at the beginning of an iteration: points move with the frames of their bodies, or as they are driven.
Vector carried_displacements(const SolidSystem& system, const SolidState& old, const Vector& s,
                             const Standing& standing);

/// Tractions at the beginning of an iteration: they turn with the body of the secondary side.
std::vector<Points3> carried_tractions(const SolidSystem& system, const SolidState& old, const Standing& standing);

/// Derivatives by the unknown motions of bodies that turn, columns of zeros for those of others.
struct TurningTangent {
  Matrix places;             ///< 3 points x free motions: of the places, the forces in space being what they are
  std::vector<Matrix> seen;  ///< per contact with a twist: of `seen_motion`, beside what follows the places
  Matrix balance;            ///< free motions x free motions
};
TurningTangent turning_tangent(const SolidSystem& system, const Standing& standing, const Vector& force,
                               const Vector& s, const Vector& step);

/// The change of all places in a step: forces that change and motions that are small.
Vector change_of_places(const SolidSystem& system, const Standing& standing, const Vector& force, const Vector& a_step,
                        const TurningTangent& tangent);

}  // namespace reye::solver
