#pragma once
#include <vector>

#include "algebra/factor.hpp"

namespace reye::solver {

using base::Matrix;
using base::Vector;

/// A symmetric stiffness without its columns f, on which no contact acts, exactly:
///   S' = S_nn - S_nf G,  f' = f_n - G^T f_f,  q_f = S_ff^-1 f_f - G q_n,  G = S_ff^-1 S_fn
class Condensed {
 public:
  Condensed() = default;
  /// `near` and `far`: columns n and f of S. Throws base::SolveError when S_ff is not definite.
  Condensed(const Matrix& S, std::vector<int> near, std::vector<int> far);

  const Matrix& stiffness() const { return S_; }
  Eigen::Index size() const { return S_.rows(); }                                          ///< columns kept
  Eigen::Index full() const { return static_cast<Eigen::Index>(near_.size() + far_.size()); }  ///< all columns

  const std::vector<int>& near() const { return near_; }
  const std::vector<int>& far() const { return far_; }

  /// Forces f on all columns: f' on those kept, and what f_f moves.
  struct Load {
    Vector near, own;
  };
  Load load(const Eigen::Ref<const Vector>& full) const;
  Vector moved(const Eigen::Ref<const Vector>& near, const Vector& own) const { return own - G_ * near; }  ///< q_f
  /// All columns from the kept ones.
  Vector expand(const Eigen::Ref<const Vector>& near, const Vector& own) const;

 private:
  std::vector<int> near_, far_;
  Matrix S_, G_;
  algebra::DenseCholesky factor_;  ///< of S_ff
};

}  // namespace reye::solver
