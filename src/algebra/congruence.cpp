#include "algebra/congruence.hpp"

#include <algorithm>
#include <vector>

namespace reye::algebra {

using base::SparseMatrix;

namespace {

using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Calls take(row of the result, value) for what column c of B^T K B is the sum of.
template <class Take>
void for_each_term(const SparseMatrix& K, const SparseMatrix& B, const RowMajor& rows, int c, Take take) {
  for (SparseMatrix::InnerIterator of_column(B, c); of_column; ++of_column)
    for (SparseMatrix::InnerIterator k(K, of_column.row()); k; ++k)
      for (RowMajor::InnerIterator of_row(rows, k.row()); of_row; ++of_row)
        take(static_cast<int>(of_row.col()), of_row.value() * k.value() * of_column.value());
}

/// B^T K B with its own pattern.
SparseMatrix congruence_of(const SparseMatrix& K, const SparseMatrix& B, const RowMajor& rows) {
  const int n = static_cast<int>(B.cols());
  std::vector<int> met(static_cast<std::size_t>(n), -1), inner;
  std::vector<double> sum(static_cast<std::size_t>(n)), values;
  inner.reserve(static_cast<std::size_t>(K.nonZeros()));
  values.reserve(static_cast<std::size_t>(K.nonZeros()));
  SparseMatrix result(n, n);
  for (int c = 0; c < n; ++c) {
    const auto first = static_cast<std::ptrdiff_t>(inner.size());
    for_each_term(K, B, rows, c, [&](int r, double value) {
      const auto at = static_cast<std::size_t>(r);
      if (met[at] == c) {
        sum[at] += value;
        return;
      }
      met[at] = c;
      sum[at] = value;
      inner.push_back(r);
    });
    if (!std::is_sorted(inner.begin() + first, inner.end())) std::sort(inner.begin() + first, inner.end());
    for (auto k = static_cast<std::size_t>(first); k < inner.size(); ++k)
      values.push_back(sum[static_cast<std::size_t>(inner[k])]);
    result.outerIndexPtr()[c + 1] = static_cast<int>(inner.size());
  }
  result.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::copy(inner.begin(), inner.end(), result.innerIndexPtr());
  std::copy(values.begin(), values.end(), result.valuePtr());
  return result;
}

/// Makes `result` of its own pattern; false where that has no place for an entry.
bool add_up(const SparseMatrix& K, const SparseMatrix& B, const RowMajor& rows, SparseMatrix& result) {
  const int n = static_cast<int>(result.cols());
  std::vector<int> place(static_cast<std::size_t>(n), -1);
  const int *outer = result.outerIndexPtr(), *inner = result.innerIndexPtr();
  double* values = result.valuePtr();
  std::fill_n(values, result.nonZeros(), 0.0);
  bool fits = true;
  for (int c = 0; c < n && fits; ++c) {
    for (int at = outer[c]; at < outer[c + 1]; ++at) place[static_cast<std::size_t>(inner[at])] = at;
    for_each_term(K, B, rows, c, [&](int r, double value) {
      const int at = place[static_cast<std::size_t>(r)];
      if (at < outer[c])
        fits = false;
      else
        values[at] += value;
    });
  }
  return fits;
}

}  // namespace

void congruence(const SparseMatrix& K, const SparseMatrix& B, SparseMatrix& result) {
  const RowMajor rows(B);
  if (result.cols() == B.cols() && result.isCompressed() && add_up(K, B, rows, result)) return;
  result = congruence_of(K, B, rows);
}

SparseMatrix symmetric_part(const SparseMatrix& K) {
  const int n = static_cast<int>(K.cols());
  const int *outer = K.outerIndexPtr(), *inner = K.innerIndexPtr();
  const double* values = K.valuePtr();
  SparseMatrix upper(n, n);
  upper.reserve((K.nonZeros() + n) / 2);
  // Rows below the diagonal of a column come in the order of the columns in which their mirror images are met.
  std::vector<int> mirror(static_cast<std::size_t>(n));
  bool mirrored = true;
  for (int j = 0; j < n && mirrored; ++j) {
    upper.startVec(j);
    int at = outer[j];
    for (; at < outer[j + 1] && inner[at] < j; ++at) {
      const int i = inner[at];
      int& opposite = mirror[static_cast<std::size_t>(i)];
      if (opposite == outer[i + 1] || inner[opposite] != j) {
        mirrored = false;
        break;
      }
      upper.insertBack(i, j) = 0.5 * (values[at] + values[opposite++]);
    }
    if (at < outer[j + 1] && inner[at] == j) upper.insertBack(j, j) = values[at++];
    mirror[static_cast<std::size_t>(j)] = at;
  }
  upper.finalize();
  for (int j = 0; j < n && mirrored; ++j) mirrored = mirror[static_cast<std::size_t>(j)] == outer[j + 1];
  return mirrored ? upper : SparseMatrix((0.5 * (K + SparseMatrix(K.transpose()))).triangularView<Eigen::Upper>());
}

}  // namespace reye::algebra
