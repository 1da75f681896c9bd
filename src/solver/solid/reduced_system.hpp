#pragma once
#include <span>
#include <utility>
#include <vector>

#include "algebra/factor.hpp"
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

/// Where a matrix is formed.
struct ReducedState {
  std::span<const contact::SkinPlace> places;
  const Standing& standing;
  const TurningTangent& tangent;
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

/// The matrix of the rows together with the balance of free motions, as dense LU. Only points in contact are unknown,
/// and in slip the shear along the slip is eliminated; what slides wears. It may serve for later steps with rows of the
/// same unknowns.
class ReducedSystem {
 public:
  /// Throws base::SolveError where the matrix is singular: then nothing holds a body. Motions of bodies that turn which
  /// cost no force, as those of a ball on one point, make no such matrix: `solve` leaves them as they are.
  void factor(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows,
              const std::vector<WearRow>& wear);
  /// The step for the residuals of these rows and what is left of the balance of free motions; `forces`: their sum.
  /// Throws base::SolveError where it is not finite, or where something drives a motion that nothing holds.
  ReducedStep solve(const std::vector<ReducedRow>& rows, const Vector& imbalance, double forces) const;
  /// Rows of the matrix that is held.
  std::size_t count() const { return count_; }

 private:
  algebra::DenseFactor factor_;
  Matrix neutral_;  ///< the matrix itself where some motion costs no force; else empty
  Vector scale_;    ///< of the free motions, which makes them comparable
  std::size_t count_ = 0;
};

}  // namespace reye::solver
