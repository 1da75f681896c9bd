#pragma once
#include <span>
#include <utility>
#include <vector>

#include "algebra/factor.hpp"
#include "contact/solid/cone.hpp"
#include "solver/solid/solid_system.hpp"

namespace reye::solver {

/// One unknown of the reduced system, the traction of a point along a direction, with its equation
///   diagonal x (change of the unknown) + weight x row . (change of w) = -residual        [MPa]
struct ReducedRow {
  int contact = 0, point = 0;
  Vec3 along = Vec3::Zero();  ///< change of the traction per unit of the unknown
  Vec3 row = Vec3::Zero();    ///< direction in which the relative motion counts, c included [MPa/mm]
  double diagonal = 0.0;
  double residual = 0.0;
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
  Vector z;  ///< per row
  Vector a;  ///< free motions
};

/// The matrix of the rows together with the balance of free motions, as dense LU. Only points in contact are unknown,
/// and in slip the shear along the slip is eliminated; what slides wears. It may serve for later steps with rows of the
/// same unknowns.
class ReducedSystem {
 public:
  /// Throws base::SolveError where the matrix is singular: then nothing holds a body.
  void factor(const SolidSystem& system, std::span<const contact::SkinPlace> places,
              const std::vector<ReducedRow>& rows, const std::vector<WearRow>& wear);
  /// The step for the residuals of these rows. Throws base::SolveError where it is not finite.
  ReducedStep solve(const std::vector<ReducedRow>& rows, const Vector& imbalance) const;
  /// Rows of the matrix that is held.
  std::size_t count() const { return count_; }

 private:
  algebra::DenseFactor factor_;
  std::size_t count_ = 0;
};

}  // namespace reye::solver
