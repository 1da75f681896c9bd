#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "algebra/factor.hpp"
#include "body/solid/solid_matrices.hpp"

namespace reye::body {

/// A solid that deforms: its factor, and what recovers all displacements from what is retained.
class ElasticSolid {
 public:
  /// Fills `out`, whose driven values and centre are set; `spare` as in `SolidBody`.
  ElasticSolid(const SolidInput& input, const std::vector<SolidPlace>& places, const std::vector<int>& retained,
               std::optional<algebra::SchurFactor> spare, SolidMatrices& out);

  Points3 displacements(const SolidMatrices& matrices, const std::vector<int>& retained, const Vector& f,
                        const Vector& s, const Vector& a) const;

  std::optional<algebra::SchurFactor> take_factor() { return std::exchange(factor_, std::nullopt); }

 private:
  struct Split;
  void factorise(base::SparseMatrix K, std::optional<algebra::SchurFactor> spare);
  void set_retained_motion(const std::vector<int>& retained);
  void set_free_modes(const SolidInput& input, const std::vector<SolidPlace>& places, SolidMatrices& out);
  void set_loads(const SolidInput& input, const SolidMatrices& out);
  void set_driven(SolidMatrices& out);
  Split split(const SolidInput& input);
  void hold_free_modes(Matrix& S) const;
  void condense(const SolidInput& input, Split S, SolidMatrices& out);
  void set_resultants(const SolidInput& input, const Matrix& of_f, const Matrix& of_s, SolidMatrices& out) const;

  SolidColumns columns_;
  std::optional<algebra::SchurFactor> factor_;
  std::vector<Vector> loads_;              ///< per driven value: forces on y, empty where it is no load
  base::SparseMatrix of_unknown_;          ///< retained points from own retained dofs and active motions
  base::SparseMatrix of_prescribed_;       ///< and from prescribed motions
  bool plain_ = false;                     ///< retained points are the first unknowns
  Matrix prescribed_;                      ///< values of prescribed motions, x driven
  Matrix modes_;                           ///< unknowns of the free modes
  Matrix pushed_, condensed_loads_;        ///< forces on the unknowns, and on unknowns and prescribed motions, x driven
  Matrix active_f_, active_s_, active_a_;  ///< the active motions from f, s, a
};

}  // namespace reye::body
