#include "solver/condensed.hpp"

#include <utility>

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
    const Matrix& S = *S_;
    factor_ = algebra::DenseCholesky(S(far_, far_));
    G_ = S(far_, near_);
    kept = S(near_, near_) - factor_.condense(G_);
  }
  S_ = std::make_shared<const Matrix>(std::move(kept));
}

Condensed Condensed::part(std::vector<int> near, std::vector<int> far) const {
  return {S_, far_.empty() ? inverse_ : nullptr, std::move(near), std::move(far)};
}

Vector Condensed::moved(const Eigen::Ref<const Vector>& near, const Vector& own) const { return own - G_ * near; }

Condensed::Load Condensed::load(const Eigen::Ref<const Vector>& full) const {
  Load load{full(near_), Vector::Zero(static_cast<Eigen::Index>(far_.size()))};
  if (far_.empty()) return load;
  const Vector far = full(far_);
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
