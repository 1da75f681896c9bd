#include "algebra/close_system.hpp"

#include <Eigen/IterativeLinearSolvers>

namespace reye::algebra {

namespace {

/// A factor in the shape that Eigen asks of preconditioners.
class Near {
 public:
  const SchurFactor* factor = nullptr;

  template <class Matrix>
  Near& analyzePattern(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  Near& factorize(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  Near& compute(const Matrix&) {
    return *this;
  }
  Vector solve(const Vector& r) const { return factor->solve_leading(r); }
  Eigen::ComputationInfo info() const { return Eigen::Success; }
};

}  // namespace

std::optional<Vector> solve_close(const SparseMatrix& K, const Vector& b, const SchurFactor& near) {
  constexpr int most = 30;
  constexpr double largest_residual = 1e-10;  // the iteration reckons with one that round-off leaves out
  if (!near.has_whole() || near.size() < K.rows()) return {};
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Upper, Near> iteration;
  iteration.preconditioner().factor = &near;
  iteration.setMaxIterations(most);
  iteration.setTolerance(1e-12);
  iteration.compute(K);
  const Vector x = iteration.solve(b);
  if (iteration.info() != Eigen::Success) return {};
  const double residual = (K.selfadjointView<Eigen::Upper>() * x - b).norm();
  if (!(residual <= largest_residual * b.norm())) return {};
  return x;
}

}  // namespace reye::algebra
