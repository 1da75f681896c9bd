#include "algebra/compliance.hpp"

#include <cmath>
#include <utility>

#include "algebra/factor.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

Compliance::Compliance(Matrix S, const std::vector<int>& held) : C_(std::move(S)), springs_(Vector::Zero(C_.rows())) {
  for (int k : held) springs_[k] = C_(k, k) > 0.0 ? C_(k, k) : 1.0;
  C_.diagonal() += springs_;
  Vector known(C_.rows());  // without a pattern that a motion of the body could have
  for (Eigen::Index k = 0; k < known.size(); ++k) known[k] = std::cos(static_cast<double>(k * k));
  const Vector image = C_ * known;
  invert(C_);
  constexpr double digits = 1e-8;
  if (!((C_ * image - known).lpNorm<Eigen::Infinity>() < digits))
    throw base::SolveError("dense inverse: springs on the columns given hold the matrix by round-off alone");
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
