#include "algebra/product.hpp"

namespace reye::algebra {

using base::Matrix;

Matrix product(const DenseView& A, const DenseView& B) { return A * B; }

Matrix transposed_product(const DenseView& A, const DenseView& B) { return A.transpose() * B; }

Matrix product_transposed(const DenseView& A, const DenseView& B) { return A * B.transpose(); }

void add_product(double factor, const DenseView& A, const DenseView& B, Eigen::Ref<Matrix> C) {
  C.noalias() += factor * A * B;
}

}  // namespace reye::algebra
