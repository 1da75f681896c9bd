#include "fit/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "fit/basis.hpp"

namespace reye::fit {

namespace {

/// Weights of logarithms, of all one; those that count for nothing are left out.
void normalise(std::vector<Likely>& noises) {
  constexpr double nothing = 1e-4;
  std::sort(noises.begin(), noises.end(), [](const Likely& a, const Likely& b) { return a.weight > b.weight; });
  const double best = noises.front().weight;
  for (Likely& one : noises) one.weight = std::exp(one.weight - best);
  std::erase_if(noises, [](const Likely& one) { return one.weight < nothing; });
  double sum = 0.0;
  for (const Likely& one : noises) sum += one.weight;
  for (Likely& one : noises) one.weight /= sum;
}

}  // namespace

Scores scores_of(const Record& record, const Matrix& columns, int asked) {
  const Matrix means = record.blocks.averaged(columns);
  const Eigen::Index own = columns.cols() - 1 - asked;
  const Matrix weighted = (record.blocks.count / record.variance).asDiagonal() * means;
  Matrix u = weighted.middleCols(own, asked);
  if (own > 0) {
    const Matrix cross = algebra::transposed_product(means.leftCols(own), weighted);
    u -= algebra::product(weighted.leftCols(own),
                          algebra::least_squares(cross.leftCols(own), cross.middleCols(own, asked)));
  }
  return {algebra::transposed_product(u, means.middleCols(own, asked)),
          algebra::transposed_product(u, means.rightCols(1)), pairs_of(record.blocks, u)};
}

Belief belief_of(const Record& record, const Matrix& columns) {
  if (record.known()) return {std::vector<Likely>(1), 0};
  Matrix means = record.blocks.averaged(columns);
  const Matrix basis = basis_of(means.leftCols(columns.cols() - 1));
  const Eigen::Index own = basis.cols();
  means = (Matrix(means.rows(), own + 1) << basis, means.rightCols(1)).finished();
  Belief belief;
  for (const Noise& noise : candidates(record.blocks, record.series->map)) {
    auto [gram, log_determinant] = weigh(record.blocks, record.series->map, noise, means);
    const Eliminated eliminated = eliminate(gram, static_cast<int>(own));
    belief.freedom = static_cast<int>(means.rows()) - eliminated.rank;
    const double squares = std::max(gram(own, own), std::numeric_limits<double>::min());
    const double log_weight =
        std::log(noise.prior) - 0.5 * (log_determinant + eliminated.log_pivots + belief.freedom * std::log(squares));
    belief.noises.push_back({noise, log_weight, squares / belief.freedom});
  }
  normalise(belief.noises);
  return belief;
}

Matrix taken_columns(const Record& record, const Model& model, const Unknowns& at) {
  constexpr double longest = 0.5;
  const Matrix columns = columns_of(record, model, at);
  const Scores scores = scores_of(record, columns, record.shifts() + static_cast<int>(at.theta.size()));
  const Matrix inverse = algebra::pseudo_inverse(scores.information);
  const Matrix covariance =
      algebra::product(algebra::product(inverse, variance_of(scores, belief_of(record, columns))), inverse);
  const Matrix bends = bends_of(record, model, at, covariance.diagonal().cwiseSqrt().cwiseMin(longest));
  Matrix taken(columns.rows(), columns.cols() + bends.cols());
  taken << bends, columns;
  return taken;
}

Matrix variance_of(const Scores& scores, const Belief& belief) {
  Matrix variance = Matrix::Zero(scores.score.size(), scores.score.size());
  for (const Likely& one : belief.noises) variance += one.weight * one.variance * variance_of(scores.pairs, one.noise);
  return variance;
}

}  // namespace reye::fit
