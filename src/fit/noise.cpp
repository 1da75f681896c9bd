#include "fit/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/factor.hpp"
#include "algebra/product.hpp"
#include "fit/markov.hpp"

namespace reye::fit {

namespace {

/// The nugget where there is none: smooth processes are else singular to rounding.
constexpr double least_nugget = 1e-6;
/// Nuggets over the values within a correlation length: below the first the correlated part is all, above the last it
/// is hidden.
constexpr std::array<double, 5> nuggets{1e-3, 1e-2, 1e-1, 1.0, 10.0};
constexpr double length_ratio = 2.0;
constexpr int orders = 3;

Weighed weigh_map(const Blocks& blocks, const Noise& noise, Matrix columns) {
  const Eigen::Index n = columns.rows();
  Matrix V(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = j; i < n; ++i) V(i, j) = correlation(noise, (blocks.at[i] - blocks.at[j]).norm());
    V(j, j) += noise.nugget / blocks.count[j];
  }
  const algebra::DenseCholesky factor(std::move(V));
  return {factor.condense(columns), factor.log_determinant()};
}

}  // namespace

std::vector<Noise> candidates(const Blocks& blocks, bool map) {
  std::vector<Noise> all{{}};
  const auto count = static_cast<double>(blocks.at.size());
  const Vec2 extent = extent_of(blocks.at);
  const double dimensions = map ? 2.0 : 1.0;
  const double longest = 0.25 * extent.maxCoeff();
  const double distance = map ? std::sqrt(extent.x() * extent.y() / count) : extent.norm() / count;
  if (count < 8 || !(distance > 0.0)) return all;
  for (int order = 0; order < orders; ++order)
    for (double length = distance; length <= longest; length *= length_ratio) {
      all.push_back({order, length, least_nugget});
      for (const double share : nuggets)
        all.push_back({order, length, share * std::pow(2.0 * length / distance, dimensions) * blocks.count.mean()});
    }
  double sum = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) sum += all[i].prior = std::pow(all[i].length_mm, 0.25);
  for (std::size_t i = 1; i < all.size(); ++i) all[i].prior /= sum;
  return all;
}

Weighed weigh(const Blocks& blocks, bool map, const Noise& noise, const Matrix& columns) {
  if (noise.order < 0) {
    const double logs = static_cast<double>(columns.rows()) * std::log(noise.nugget) - blocks.count.array().log().sum();
    const Matrix weighted = (blocks.count / noise.nugget).asDiagonal() * columns;
    return {algebra::transposed_product(columns, weighted), logs};
  }
  if (map) return weigh_map(blocks, noise, columns);
  const Whitened white = whiten_along(blocks, noise, columns);
  return {algebra::transposed_product(white.columns, white.columns), white.log_determinant};
}

Eliminated eliminate(Matrix& gram, int count) {
  constexpr double dependent = 1e-10;
  Eliminated result;
  const Vector whole = gram.diagonal();
  for (int j = 0; j < count; ++j) {
    const double pivot = gram(j, j);
    if (pivot > dependent * whole[j]) {
      const Vector column = gram.col(j);
      gram -= column * column.transpose() / pivot;
      result.log_pivots += std::log(pivot);
      ++result.rank;
    }
    gram.row(j).setZero();
    gram.col(j).setZero();
  }
  return result;
}

}  // namespace reye::fit
