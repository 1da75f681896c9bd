#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "algebra/compliance.hpp"
#include "algebra/factor.hpp"

namespace reye::solver {

using base::Matrix;
using base::Vector;

/// A stiffness without its columns f, on which no contact acts, exactly:
///   S' = S_nn - S_nf G,  f' = f_n - S_nf S_ff^-1 f_f,  q_f = S_ff^-1 f_f - G q_n,  G = S_ff^-1 S_fn
/// by Cholesky, where S_nf S_ff^-1 is G^T; a tangent that is not symmetric, or not definite, by LU.
class Condensed {
 public:
  Condensed() = default;
  /// Of a linear body, whose S is symmetric. `near` and `far`: columns n and f of S. `inverse`: the inverse to use in
  /// place of S where choices follow one another, or null. Where no column is left out both are shared. Throws
  /// base::SolveError when S_ff is not definite.
  Condensed(std::shared_ptr<const Matrix> S, std::shared_ptr<const algebra::Compliance> inverse, std::vector<int> near,
            std::vector<int> far);
  /// Of the tangent S of a nonlinear body. Throws base::SolveError when S_ff is singular.
  static Condensed tangent(const Matrix& S, std::vector<int> near, std::vector<int> far);
  /// A choice of the columns kept; not of a tangent.
  Condensed part(std::vector<int> near, std::vector<int> far) const;

  const Matrix& stiffness() const { return *S_; }
  Eigen::Index size() const { return S_->rows(); }                                             ///< columns kept
  Eigen::Index full() const { return static_cast<Eigen::Index>(near_.size() + far_.size()); }  ///< all columns

  const std::vector<int>& near() const { return near_; }
  const std::vector<int>& far() const { return far_; }

  /// Forces f on all columns: f' on those kept, and the displacements q_f by f_f.
  struct Load {
    Vector near, own;
  };
  Load load(const Eigen::Ref<const Vector>& full) const;
  Vector moved(const Eigen::Ref<const Vector>& near, const Vector& own) const;  ///< q_f
  /// All columns from the kept ones.
  Vector expand(const Eigen::Ref<const Vector>& near, const Vector& own) const;

 private:
  Matrix by_cholesky(const Matrix& S);
  Matrix by_lu(const Matrix& S);

  std::vector<int> near_, far_;
  std::shared_ptr<const Matrix> S_ = std::make_shared<const Matrix>();
  Matrix G_;
  std::shared_ptr<const algebra::Compliance> inverse_;
  algebra::DenseCholesky factor_;  ///< of S_ff, where there is neither an inverse nor LU
  /// Of a tangent that is not symmetric, or not definite.
  struct General {
    algebra::DenseFactor factor;  ///< of S_ff
    Matrix S_nf;
  };
  std::optional<General> general_;
};

}  // namespace reye::solver
