#include "algebra/gathered_product.hpp"

#include <algorithm>
#include <vector>

#include "algebra/blas.hpp"
#include "base/cores.hpp"

namespace reye::algebra {

namespace {

using base::Matrix;
using base::SparseMatrix;

constexpr int columns_at_once = 32;

/// Columns [first, first + values.cols()) of a sparse matrix on the rows that they touch.
struct Gathered {
  int first = 0;
  std::vector<int> rows;  ///< ascending
  Matrix values;          ///< rows x columns
};

/// Rows that any column from `first` to `end` touches, ascending.
std::vector<int> touched_rows(const SparseMatrix& A, int first, int end) {
  std::vector<char> touched(static_cast<std::size_t>(A.rows()), 0);
  for (int k = first; k < end; ++k)
    for (SparseMatrix::InnerIterator it(A, k); it; ++it) touched[static_cast<std::size_t>(it.row())] = 1;
  std::vector<int> rows;
  for (int i = 0; i < static_cast<int>(touched.size()); ++i)
    if (touched[static_cast<std::size_t>(i)]) rows.push_back(i);
  return rows;
}

std::vector<Gathered> gathered(const SparseMatrix& A) {
  std::vector<Gathered> blocks;
  const int count = static_cast<int>(A.cols());
  for (int first = 0; first < count; first += columns_at_once) {
    const int end = std::min(count, first + columns_at_once);
    Gathered block{first, touched_rows(A, first, end), {}};
    block.values = Matrix::Zero(static_cast<Eigen::Index>(block.rows.size()), end - first);
    for (int k = first; k < end; ++k)
      for (SparseMatrix::InnerIterator it(A, k); it; ++it) {
        const auto at = std::lower_bound(block.rows.begin(), block.rows.end(), static_cast<int>(it.row()));
        block.values(at - block.rows.begin(), k - first) = it.value();
      }
    if (!block.rows.empty()) blocks.push_back(std::move(block));
  }
  return blocks;
}

/// A B, or A^T B.
Matrix multiplied(const char* transposed, const Matrix& A, const Matrix& B) {
  const bool plain = *transposed == 'N';
  const int m = static_cast<int>(plain ? A.rows() : A.cols()), n = static_cast<int>(B.cols());
  const int k = static_cast<int>(B.rows()), lda = static_cast<int>(A.rows());
  const double one = 1.0, zero = 0.0;
  Matrix result(m, n);
  dgemm_(transposed, "N", &m, &n, &k, &one, A.data(), &lda, B.data(), &k, &zero, result.data(), &m);
  return result;
}

/// Places of ascending numbers in an ascending list that holds them all.
std::vector<int> places(const std::vector<int>& numbers, const std::vector<int>& list) {
  std::vector<int> found;
  auto at = list.begin();
  for (const int number : numbers) {
    at = std::lower_bound(at, list.end(), number);
    found.push_back(static_cast<int>(at - list.begin()));
  }
  return found;
}

}  // namespace

Matrix gathered_product(const SparseMatrix& L, const Matrix& C, const SparseMatrix& R) {
  single_thread();
  Matrix product = Matrix::Zero(L.cols(), R.cols());
  const auto left = gathered(L);
  const auto rows = touched_rows(L, 0, static_cast<int>(L.cols()));
  std::vector<std::vector<int>> place;
  for (const auto& block : left) place.push_back(places(block.rows, rows));
  const auto all_right = gathered(R);
  base::side_by_side(static_cast<int>(all_right.size()), [&](int k) {
    const auto& right = all_right[static_cast<std::size_t>(k)];
    const Matrix moved = multiplied("N", C(rows, right.rows), right.values);
    for (std::size_t b = 0; b < left.size(); ++b)
      product.block(left[b].first, right.first, left[b].values.cols(), right.values.cols()) =
          multiplied("T", left[b].values, moved(place[b], Eigen::all));
  });
  return product;
}

}  // namespace reye::algebra
