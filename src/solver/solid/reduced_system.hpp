#pragma once
#include <span>
#include <utility>
#include <vector>

#include "contact/solid/cone.hpp"
#include "solver/solid/turning_motion.hpp"

namespace reye::solver {

/// One unknown of the reduced system, the traction of a point along a direction, with its equation
///   diagonal x (change of the unknown) + weight x row . (change of w) = -residual        [MPa]
struct ReducedRow {
  int contact = 0, point = 0;
  Vec3 along = Vec3::Zero();  ///< change of the traction per unit of the unknown
  Vec3 row = Vec3::Zero();    ///< direction in which the relative motion counts, c included [MPa/mm]
  double diagonal = 0.0;
  double residual = 0.0;
  bool slides = false;  ///< w is the slip of the increment, else the gap
};

/// What a step starts from.
struct ReducedState {
  std::span<const contact::SkinPlace> places;
  const Standing& standing;
  const TurningTangent& tangent;
  const Vector& imbalance;  ///< of the free motions
  double forces = 0.0;      ///< their sum
};

/// The volume V that a sliding point wears off one side in the increment, beside the rows:
///   dV = of_traction . dz + of_motion . dw,
/// and what it adds to equations of normal contact: `opens` lists (row, c x opening of its gap per volume).
struct WearRow {
  int contact = 0, point = 0;
  Vec3 of_traction = Vec3::Zero(), of_motion = Vec3::Zero();
  std::vector<std::pair<int, double>> opens{};
};

/// The change of all unknowns in one Newton step.
struct ReducedStep {
  Vector z;              ///< per row
  Vector a;              ///< free motions
  bool neutral = false;  ///< a motion of a body that turns costs no force at present and was left as it is
};

/// Solves the rows together with the balance of free motions, by dense LU. Only points in contact are unknown, and in
/// slip the shear along the slip is eliminated. Throws base::SolveError where the matrix is singular: then nothing
/// holds a body. Motions of bodies that turn which cost no force, as those of a ball on one point, are left as they are
/// while nothing drives them.
ReducedStep solve_reduced(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows,
                          const std::vector<WearRow>& wear);

}  // namespace reye::solver
