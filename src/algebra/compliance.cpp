#include "algebra/compliance.hpp"

#include <utility>

#include "algebra/factor.hpp"

namespace reye::algebra {

Compliance::Compliance(Matrix S, const std::vector<int>& held) : C_(std::move(S)), springs_(Vector::Zero(C_.rows())) {
  for (int k : held) springs_[k] = C_(k, k) > 0.0 ? C_(k, k) : 1.0;
  C_.diagonal() += springs_;
  invert_held(C_);
}

Compliance::Condensed Compliance::condense(const std::vector<int>& near, const std::vector<int>& far) const {
  Condensed condensed{C_(near, near), {}};
  invert(condensed.S);
  condensed.G.noalias() = -C_(far, near) * condensed.S;
  condensed.S.diagonal() -= springs_(near);
  return condensed;
}

Vector Compliance::moved(const Vector& f_far, const std::vector<int>& near, const std::vector<int>& far,
                         const Matrix& G) const {
  if (f_far.isZero(0.0)) return f_far;
  Vector f = Vector::Zero(C_.rows());
  f(far) = f_far;
  const Vector u = C_ * f;
  return u(far) + G * u(near);
}

}  // namespace reye::algebra
