#pragma once
#include <vector>

#include "base/linalg.hpp"

namespace reye::algebra {

using base::Matrix;
using base::Vector;

/// The inverse C of a symmetric stiffness S that springs K hold in a few columns. Without its columns f, of any choice
/// that leaves those few in the rest n,
///   S_nn - S_nf S_ff^-1 S_fn = C_nn^-1 - K_nn                                               [README (5)]
/// at the price of n, not of f: one inversion serves every choice.
class Compliance {
 public:
  /// `held`: columns that must never be left out; S with springs on them is definite, and so well that its inverse
  /// returns a vector to eight digits, else throws base::SolveError. A spring is as stiff as its column.
  Compliance(Matrix S, const std::vector<int>& held);

  /// S' and G = S_ff^-1 S_fn of a choice.
  struct Condensed {
    Matrix S, G;
  };
  Condensed condense(const std::vector<int>& near, const std::vector<int>& far) const;
  /// S_ff^-1 f_f of the same choice.
  Vector moved(const Vector& f_far, const std::vector<int>& near, const std::vector<int>& far, const Matrix& G) const;

 private:
  Matrix C_;
  Vector springs_;  ///< per column, mostly zero
};

}  // namespace reye::algebra
