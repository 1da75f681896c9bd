#pragma once
#include <vector>

#include "body/condensation.hpp"

namespace reye::body {

using base::SparseMatrix;

/// Cells of a body whose tangent K is kept, condensed once onto the columns that they share with other cells or that
/// are retained (a superelement):
///   S = K_oo - K_oi K_ii^-1 K_io,   i: inside, o: shared.
class Superelement {
 public:
  /// K: tangent of those cells in all columns of the body; `symmetric`: whether it is. `inside`: per column, whether
  /// only its cells touch it. `tangent`: whether S is of K or of its symmetric part, which is taken only where it is
  /// definite. Throws base::SolveError where K_ii is singular.
  Superelement(const SparseMatrix& K, const std::vector<char>& inside, bool symmetric, Tangent tangent);

  const std::vector<int>& shared() const { return shared_; }
  const base::Matrix& stiffness() const { return condensation_.schur(); }  ///< S
  /// r_o - K_oi K_ii^-1 r_i in the shared columns of r; those inside stay. Nothing is done where no |r_i| is greater
  /// than `negligible`.
  void condense(base::Vector& r, double negligible = 0.0) const;
  /// Puts the solution for loads r, whose shared columns stand in u, into the columns inside.
  void recover(const base::Vector& r, base::Vector& u) const;

 private:
  base::Vector loads_inside(const base::Vector& r) const;
  std::vector<int> inside_, shared_;
  Condensation condensation_;
};

}  // namespace reye::body
