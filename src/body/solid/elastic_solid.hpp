#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "algebra/factor.hpp"
#include "body/solid/solid_rows.hpp"

namespace reye::body {

/// A solid that deforms: its factor, and what recovers all displacements from what is retained.
class ElasticSolid {
 public:
  /// Fills `out`, whose driven values and centre are set; `spare` as in `SolidBody`.
  ElasticSolid(const SolidInput& input, const std::vector<SolidPlace>& places, const std::vector<int>& retained,
               std::optional<algebra::SchurFactor> spare, SolidMatrices& out);

  Points3 displacements(const SolidMatrices& matrices, const std::vector<int>& retained, const Vector& f,
                        const Vector& s, const Vector& a) const;

  /// In another shape of the same cells and nodes, without a factor of it: conjugate gradients with this one. None
  /// where they do not converge. `matrices`: of this shape; `shape`, `places`: of the other.
  std::optional<Points3> displacements_in(const SolidInput& shape, const std::vector<SolidPlace>& places,
                                          const std::vector<int>& retained, const SolidMatrices& matrices,
                                          const Vector& f, const Vector& s, const Vector& a) const;

  std::optional<algebra::SchurFactor> take_factor() { return std::exchange(factor_, std::nullopt); }

 private:
  void factorise(base::SparseMatrix K, std::optional<algebra::SchurFactor> spare);
  void set_driven(SolidMatrices& out);
  void condense(const SolidInput& input, SolidMatrices& out);
  void set_resultants(const SolidInput& input, const Matrix& of_f, const Matrix& of_s, SolidMatrices& out) const;

  SolidRows rows_;
  std::optional<algebra::SchurFactor> factor_;
  Matrix pushed_, condensed_loads_;        ///< forces on the unknowns, and on unknowns and prescribed motions, x driven
  Matrix active_f_, active_s_, active_a_;  ///< the active motions from f, s, a
};

}  // namespace reye::body
