#include "fit/basis.hpp"

#include <utility>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"

namespace reye::fit {

Matrix basis_beside(const Matrix& basis, Matrix columns, double least) {
  for (auto column : columns.colwise())
    if (const double length = column.norm(); length > 0.0) column /= length;
  for (int pass = 0; pass < 2; ++pass) columns -= algebra::product(basis, algebra::transposed_product(basis, columns));
  const auto [values, U, V] = algebra::right_singular_values(columns);
  Eigen::Index rank = 0;
  while (rank < values.size() && values[rank] > least) ++rank;
  return algebra::product(columns, V.leftCols(rank)) * values.head(rank).cwiseInverse().asDiagonal();
}

Matrix basis_of(Matrix columns) {
  constexpr double round_off = 1e-7;
  const Matrix none(columns.rows(), 0);
  return basis_beside(none, std::move(columns), round_off);
}

}  // namespace reye::fit
