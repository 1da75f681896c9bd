#include "algebra/product.hpp"

#include "algebra/blas.hpp"

namespace reye::algebra {

using base::Matrix;

Matrix product(const DenseView& A, const DenseView& B) { return A * B; }

Matrix transposed_product(const DenseView& A, const DenseView& B) { return A.transpose() * B; }

Matrix product_transposed(const DenseView& A, const DenseView& B) { return A * B.transpose(); }

void add_product(double factor, const DenseView& A, const DenseView& B, Eigen::Ref<Matrix> C) {
  C.noalias() += factor * A * B;
}

void add_product(const DenseView& A, const Eigen::Ref<const base::Vector>& x, Eigen::Ref<base::Vector> y) {
  single_thread();
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()), stride = static_cast<int>(A.outerStride());
  const int step = 1;
  const double one = 1.0;
  dgemv_("N", &m, &n, &one, A.data(), &stride, x.data(), &step, &one, y.data(), &step);
}

}  // namespace reye::algebra
