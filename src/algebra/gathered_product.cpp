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

/// C = sum C + factor A^T B^T.
void add_transposed(double factor, const Matrix& A, const Matrix& B, double sum, Eigen::Ref<Matrix> C) {
  const int m = static_cast<int>(A.cols()), n = static_cast<int>(B.rows()), k = static_cast<int>(A.rows());
  const int stride = static_cast<int>(C.outerStride());
  dgemm_("T", "T", &m, &n, &k, &factor, A.data(), &k, B.data(), &n, &sum, C.data(), &stride);
}

/// Numbers that follow each other: `count` of them from `first`, in a list from `at`.
struct Run {
  int first = 0, at = 0, count = 0;
};

std::vector<Run> runs_of(const std::vector<int>& numbers, int longest) {
  std::vector<Run> runs;
  for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
    const int number = numbers[static_cast<std::size_t>(i)];
    if (i % longest == 0 || runs.back().first + runs.back().count != number) runs.push_back({number, i, 0});
    ++runs.back().count;
  }
  return runs;
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

constexpr int rows_at_once = 512;  // of C: what is copied of it stays in the cache until it is used

/// (C(rows, block.rows) block.values)^T.
Matrix moved_by(const Gathered& block, const Matrix& C, const std::vector<Run>& rows, int count) {
  Matrix moved(block.values.cols(), count), part;
  for (auto run = rows.begin(); run != rows.end();) {
    const int top = run->at;
    part.resize(std::min(rows_at_once, count - top), block.values.rows());
    for (; run != rows.end() && run->at < top + rows_at_once; ++run)
      for (Eigen::Index k = 0; k < part.cols(); ++k)
        part.col(k).segment(run->at - top, run->count) =
            C.col(block.rows[static_cast<std::size_t>(k)]).segment(run->first, run->count);
    add_transposed(1.0, block.values, part, 0.0, moved.middleCols(top, part.rows()));
  }
  return moved;
}

}  // namespace

void subtract_gathered_product(const SparseMatrix& L, const Matrix& C, const SparseMatrix& R, Eigen::Ref<Matrix> A) {
  single_thread();
  const auto left = gathered(L);
  const auto rows = touched_rows(L, 0, static_cast<int>(L.cols()));
  std::vector<std::vector<int>> place;
  for (const auto& block : left) place.push_back(places(block.rows, rows));
  const auto runs = runs_of(rows, rows_at_once);
  const auto all_right = gathered(R);
  base::side_by_side(static_cast<int>(all_right.size()), [&](int k) {
    const auto& right = all_right[static_cast<std::size_t>(k)];
    const Matrix moved = moved_by(right, C, runs, static_cast<int>(rows.size()));
    for (std::size_t b = 0; b < left.size(); ++b)
      add_transposed(-1.0, left[b].values, moved(Eigen::all, place[b]), 1.0,
                     A.block(left[b].first, right.first, left[b].values.cols(), right.values.cols()));
  });
}

}  // namespace reye::algebra
