#include "solver/condensed.hpp"

#include <utility>

namespace reye::solver {

Condensed::Condensed(const Matrix& S, std::vector<int> near, std::vector<int> far)
    : near_(std::move(near)), far_(std::move(far)), S_(S(near_, near_)) {
  own_ = Vector::Zero(static_cast<Eigen::Index>(far_.size()));
  if (far_.empty()) return;
  factor_ = algebra::DenseCholesky(S(far_, far_));
  G_ = S(far_, near_);
  S_ -= factor_.condense(G_);
}

Vector Condensed::load(const Eigen::Ref<const Vector>& full) {
  Vector near = full(near_);
  if (far_.empty()) return near;
  const Vector far = full(far_);
  near.noalias() -= G_.transpose() * far;
  own_ = factor_.solve(far);
  return near;
}

Vector Condensed::moved(const Eigen::Ref<const Vector>& near) const { return own_ - G_ * near; }

Vector Condensed::expand(const Eigen::Ref<const Vector>& near) const {
  Vector full(this->full());
  full(near_) = near;
  if (!far_.empty()) full(far_) = moved(near);
  return full;
}

}  // namespace reye::solver
