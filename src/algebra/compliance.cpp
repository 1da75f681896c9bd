#include "algebra/compliance.hpp"

#include <string>
#include <utility>

#include "algebra/blas.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

namespace {

/// Replaces a symmetric definite matrix by its inverse, both triangles.
void invert(Matrix& A) {
  single_thread();
  const int n = static_cast<int>(A.rows());
  int info = 0;
  dpotrf_("L", &n, A.data(), &n, &info);
  if (info == 0) dpotri_("L", &n, A.data(), &n, &info);
  if (info != 0)
    throw base::SolveError("dense inverse: the matrix of " + std::to_string(n) + " rows is not positive definite");
  A.triangularView<Eigen::StrictlyUpper>() = A.transpose();
}

}  // namespace

Compliance::Compliance(Matrix S, const std::vector<int>& held) : C_(std::move(S)), springs_(Vector::Zero(C_.rows())) {
  for (int k : held) springs_[k] = C_(k, k) > 0.0 ? C_(k, k) : 1.0;
  C_.diagonal() += springs_;
  invert(C_);
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
