#include "algebra/schur_analysis.hpp"

#include <algorithm>
#include <numeric>

namespace reye::algebra {

std::vector<int> retained_last(const SparseMatrix& upper, int retained, Ordering by) {
  const int n = static_cast<int>(upper.rows()), interior = n - retained;
  std::vector<int> order =
      by == Ordering::minimum_degree ? minimum_degree(upper, interior) : nested_dissection(upper, interior);
  order.resize(static_cast<size_t>(n));
  std::iota(order.begin() + interior, order.end(), interior);
  return order;
}

Entries::Entries(const SparseMatrix& A)
    : start(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1),
      row(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros()) {}

bool Entries::are_of(const SparseMatrix& A) const {
  return std::equal(start.begin(), start.end(), A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1) &&
         std::equal(row.begin(), row.end(), A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
}

SchurAnalysis::SchurAnalysis(SparseMatrix& upper, int c, Ordering by) : retained(c), ordering(by), entries(upper) {
  std::vector<int> order = retained_last(upper, c, by);
  symbolic = analyse(upper, order);
}

bool SchurAnalysis::fits(const SparseMatrix& upper, int c, Ordering by) const {
  return c == retained && by == ordering && entries.are_of(upper);
}

}  // namespace reye::algebra
