#pragma once
#include "base/linalg.hpp"

/// Products of dense matrices whose sizes the compiler does not know, by Eigen. They are compiled here alone: each pair
/// of types costs the compiler half a second or more in every file that names it. Loops over points and products of
/// fixed sizes name Eigen's own.
namespace reye::algebra {

/// A matrix, or a block of one, without a copy where its columns are contiguous.
using DenseView = Eigen::Ref<const base::Matrix, 0, Eigen::OuterStride<>>;

base::Matrix product(const DenseView& A, const DenseView& B);             ///< A B
base::Matrix transposed_product(const DenseView& A, const DenseView& B);  ///< A^T B
base::Matrix product_transposed(const DenseView& A, const DenseView& B);  ///< A B^T

/// C += factor A B, without a copy of the product.
void add_product(double factor, const DenseView& A, const DenseView& B, Eigen::Ref<base::Matrix> C);

/// y += A x, by BLAS, which reads a matrix beyond the caches faster than Eigen does.
void add_product(const DenseView& A, const Eigen::Ref<const base::Vector>& x, Eigen::Ref<base::Vector> y);

}  // namespace reye::algebra
