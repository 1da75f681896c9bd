#pragma once
#include <Eigen/Cholesky>
#include <vector>

#include "solver/reach.hpp"

namespace reye::solver {

/// The system on the columns of the reach and of the supports:
///   S' = S_nn - S_nf S_ff^-1 S_fn,  f' = f_n - S_nf S_ff^-1 f_f,  q_f = S_ff^-1 (f_f - S_fn q_n)
/// per linear body; f: columns of contact nodes out of reach. Rigid bodies keep all their columns.
class Reduction {
 public:
  Reduction() = default;
  Reduction(const System& system, const Reach& reach);

  int size() const { return static_cast<int>(kept_.size()); }
  int index(int column) const { return index_[column]; }  ///< reduced index of a global column, -1 out of reach
  int first(int body) const { return first_[body]; }      ///< reduced index of a body's first kept column

  Vector restrict_to(const Vector& q) const;
  /// Forces of all loads, f' on the kept columns; remembers what they move out of reach for `expand`.
  Vector loads(const System& system, const std::vector<Vector>& load_factors);
  const Matrix& stiffness(int body) const { return parts_[body].S; }  ///< empty for a rigid body
  /// All global columns from the kept ones; `scatter` leaves those out of reach at zero.
  Vector expand(const Vector& reduced) const;
  Vector scatter(const Vector& reduced) const;

 private:
  struct Part {
    std::vector<int> near, far;  ///< columns of the body's q
    Matrix S;                    ///< S'
    Matrix G;                    ///< S_ff^-1 S_fn
    Eigen::LLT<Matrix> factor;   ///< of S_ff
    Vector own;                  ///< S_ff^-1 f_f
  };
  std::vector<int> kept_, index_, first_, offset_;
  std::vector<Part> parts_;
};

}  // namespace reye::solver
