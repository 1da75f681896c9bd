#include "algebra/decompose.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

namespace reye::algebra {

Eigenpairs eigenpairs(const Matrix& A) {
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(A);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

SingularValues singular_values(const Matrix& A) {
  const Eigen::JacobiSVD<Matrix> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixU(), svd.matrixV()};
}

SingularValues right_singular_values(const Matrix& A) {
  const Eigen::JacobiSVD<Matrix> svd(A, Eigen::ComputeFullV);
  return {svd.singularValues(), {}, svd.matrixV()};
}

Matrix pseudo_inverse(const Matrix& A) {
  if (A.size() == 0) return Matrix::Zero(A.cols(), A.rows());
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

Matrix least_squares(const Matrix& A, const Matrix& B) {
  if (A.size() == 0) return Matrix::Zero(A.cols(), B.cols());
  return A.completeOrthogonalDecomposition().solve(B);
}

Matrix least_squares(const Matrix& A, const Matrix& B, double least) {
  Eigen::CompleteOrthogonalDecomposition<Matrix> solver;
  solver.setThreshold(least);
  return solver.compute(A).solve(B);
}

Matrix solve_symmetric(const Matrix& A, const Matrix& B) { return A.ldlt().solve(B); }

LeadingColumns leading_columns(const Matrix& A) {
  const Eigen::ColPivHouseholderQR<Matrix> qr(A);
  const Eigen::Index count = std::min(A.rows(), A.cols());
  const auto& order = qr.colsPermutation().indices();
  return {{order.begin(), order.begin() + count}, qr.matrixR().diagonal().head(count).cwiseAbs()};
}

}  // namespace reye::algebra
