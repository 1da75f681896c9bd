#include "solver/condensed.hpp"

#include <utility>

namespace reye::solver {

Condensed::Condensed(const Matrix& S, std::vector<int> near, std::vector<int> far)
    : near_(std::move(near)), far_(std::move(far)), S_(S(near_, near_)) {
  if (far_.empty()) return;
  factor_ = algebra::DenseCholesky(S(far_, far_));
  G_ = S(far_, near_);
  S_ -= factor_.condense(G_);
}

Condensed::Load Condensed::load(const Eigen::Ref<const Vector>& full) const {
  Load load{full(near_), Vector::Zero(static_cast<Eigen::Index>(far_.size()))};
  if (far_.empty()) return load;
  const Vector far = full(far_);
  load.near.noalias() -= G_.transpose() * far;
  load.own = factor_.solve(far);
  return load;
}

Vector Condensed::expand(const Eigen::Ref<const Vector>& near, const Vector& own) const {
  Vector full(this->full());
  full(near_) = near;
  if (!far_.empty()) full(far_) = moved(near, own);
  return full;
}

}  // namespace reye::solver
