#include "solver/condensed.hpp"

#include <utility>

#include "algebra/product.hpp"
#include "base/errors.hpp"

namespace reye::solver {

Condensed::Condensed(std::shared_ptr<const Matrix> whole, std::shared_ptr<const algebra::Compliance> inverse,
                     std::vector<int> near, std::vector<int> far)
    : near_(std::move(near)), far_(std::move(far)), S_(std::move(whole)), inverse_(std::move(inverse)) {
  if (far_.empty()) return;
  Matrix kept;
  if (inverse_) {
    auto condensed = inverse_->condense(near_, far_);
    kept = std::move(condensed.S);
    G_ = std::move(condensed.G);
  } else {
    kept = by_cholesky(*S_);
  }
  S_ = std::make_shared<const Matrix>(std::move(kept));
}

Condensed Condensed::tangent(const Matrix& S, std::vector<int> near, std::vector<int> far) {
  Condensed result;
  result.near_ = std::move(near);
  result.far_ = std::move(far);
  if (result.far_.empty()) {
    result.S_ = std::make_shared<const Matrix>(S);
    return result;
  }
  std::optional<Matrix> kept;
  if (S == S.transpose()) {
    try {
      kept = result.by_cholesky(S);
    } catch (const base::SolveError&) {  // not definite, as where a material softens
    }
  }
  if (!kept) kept = result.by_lu(S);
  result.S_ = std::make_shared<const Matrix>(std::move(*kept));
  return result;
}

Matrix Condensed::by_cholesky(const Matrix& S) {
  factor_ = algebra::DenseCholesky(S(far_, far_));
  G_ = S(far_, near_);
  return S(near_, near_) - factor_.condense(G_);
}

Matrix Condensed::by_lu(const Matrix& S) {
  Matrix S_ff = S(far_, far_);
  general_.emplace();
  general_->factor.factor(S_ff);
  general_->S_nf = S(near_, far_);
  G_ = general_->factor.solve_columns(S(far_, near_));
  return S(near_, near_) - algebra::product(general_->S_nf, G_);
}

Condensed Condensed::part(std::vector<int> near, std::vector<int> far) const {
  return {S_, far_.empty() ? inverse_ : nullptr, std::move(near), std::move(far)};
}

Vector Condensed::moved(const Eigen::Ref<const Vector>& near, const Vector& own) const { return own - G_ * near; }

Condensed::Load Condensed::load(const Eigen::Ref<const Vector>& full) const {
  Load load{full(near_), Vector::Zero(static_cast<Eigen::Index>(far_.size()))};
  if (far_.empty()) return load;
  const Vector far = full(far_);
  if (general_) {
    load.own = general_->factor.solve(far);
    load.near.noalias() -= general_->S_nf * load.own;
    return load;
  }
  load.near.noalias() -= G_.transpose() * far;
  load.own = inverse_ ? inverse_->moved(far, near_, far_, G_) : factor_.solve(far);
  return load;
}

Vector Condensed::expand(const Eigen::Ref<const Vector>& near, const Vector& own) const {
  Vector full(this->full());
  full(near_) = near;
  if (!far_.empty()) full(far_) = moved(near, own);
  return full;
}

}  // namespace reye::solver
