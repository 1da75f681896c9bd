#pragma once
#include <optional>
#include <vector>

#include "body/condensation.hpp"
#include "body/nonlinear_equations.hpp"
#include "body/superelement.hpp"

namespace reye::body {

/// The tangent of a nonlinear body, condensed to its retained columns. Only tangents that change are made again: of
/// cells that yield or have turned or stretched, and those around them. The others keep their tangent in a superelement
/// until one of them yields, too. Of those that are made again, single cells keep theirs while they are elastic and
/// have hardly turned or stretched. Residuals are always those of all cells, so that Newton's solution does not depend
/// on which ones those are.
class CondensedTangent {
 public:
  explicit CondensedTangent(const NonlinearEquations& of);

  /// Sets f and r at the unknowns v without translation; the tangent stays. Throws base::SolveError.
  void measure(const NonlinearEquations& of, const Interior& before, const Vector& v, const Vector& load_factors);
  /// Makes the tangent where `measure` was called last. Throws base::SolveError.
  void make(const NonlinearEquations& of, const Interior& before, Tangent tangent);
  /// Largest force on interior columns that the present tangent leaves out where it is a symmetric part, of the step
  /// from where it was made to where `measure` was called last. What is kept in the superelement is not counted.
  double left_out(const NonlinearEquations& of) const;
  /// Nothing is kept: what follows does not depend on states before it.
  void forget();

  const Vector& displacement() const { return at_.u; }  ///< where `measure` was called last
  const Matrix& schur() const { return condensation().schur(); }
  /// r of all columns, condensed to the retained ones.
  Vector condense(const Vector& r) const;
  /// All columns for loads r and known retained ones.
  Vector recover(const Vector& r, const Vector& retained) const;

  fem::InternalForce f;
  Vector r;             ///< [r_i; r_c]
  double changing = 1;  ///< share of the cells whose tangent `make` made

 private:
  using Flags = std::vector<char>;
  struct Whole {
    base::SparseMatrix K, reduced;
    Condensation condensation;
  };
  /// What is left beside the superelement.
  struct Rest {
    Superelement kept;
    Tangent kept_as;           ///< what `kept` was asked for
    std::vector<int> columns;  ///< of the body
    base::SparseMatrix B;      ///< of these columns
    fem::Pattern pattern;
    base::SparseMatrix K, kept_stiffness, reduced;
    Condensation condensation;
  };

  /// Where f and r were measured.
  struct Place {
    Vector v, u, load_factors, unbalanced;
    base::SparseMatrix B;  ///< of v, or of any v where it does not depend on it
    Flags yields;          ///< per cell
  };

  bool divides(const NonlinearEquations& of) const;
  void renew_cells(const NonlinearEquations& of, const Interior& before, Tangent tangent, const Flags& wanted);
  void make_whole(const NonlinearEquations& of, const Interior& before, Tangent tangent);
  bool make_rest(const NonlinearEquations& of, const Interior& before, Tangent tangent);
  bool divide(const NonlinearEquations& of, const Interior& before, Tangent tangent);
  Flags changed(const NonlinearEquations& of);
  double negligible() const;
  const Condensation& condensation() const { return divided_ ? rest_->condensation : whole_.condensation; }

  Place at_;
  std::vector<std::vector<int>> cells_of_;  ///< per node
  Whole whole_;
  std::optional<Rest> rest_;
  bool divided_ = false;   ///< whether the present tangent is that of `rest_`
  base::Matrix cells_;     ///< tangents of single cells (fem::cell_tangents)
  base::Matrix made_for_;  ///< per cell a column: displacements of its corners for which its tangent was made
  Flags yielded_;          ///< per cell: when its tangent was made, or since; or it has none
  Flags changing_;         ///< per cell
  std::vector<int> last_;  ///< per cell: number of the last tangent at which it changed
  Vector kept_at_;         ///< u at which tangents were kept
  Vector made_at_;         ///< v at which the present tangent was made
  int made_ = 0, divided_at_ = 0, whole_until_ = 0, wait_ = 4;
};

}  // namespace reye::body
