#include "fit/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/decompose.hpp"
#include "fit/pairs.hpp"

namespace reye::fit {

namespace {

/// Weights of logarithms: of all one, those that count for nothing left out.
void normalise(std::vector<Told>& told, const std::vector<double>& logs) {
  constexpr double nothing = 1e-4;
  const double best = *std::max_element(logs.begin(), logs.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const double weight = std::exp(logs[i] - best);
    told[i].weight = weight > nothing ? weight : 0.0;
    sum += told[i].weight;
  }
  for (Told& one : told) one.weight /= sum;
  std::erase_if(told, [](const Told& one) { return one.weight == 0.0; });
}

}  // namespace

Evidence evidence_of(const Record& record, const Matrix& columns, int asked, const std::vector<Noise>& noises) {
  const Matrix means = record.blocks.averaged(columns);
  const Eigen::Index own = columns.cols() - 1 - asked;
  const Vector weights = record.blocks.count / record.variance;
  const auto nuisances = means.leftCols(own);
  const Matrix J =
      means.middleCols(own, asked) -
      nuisances * algebra::least_squares(nuisances.transpose() * weights.asDiagonal() * nuisances,
                                         nuisances.transpose() * weights.asDiagonal() * means.middleCols(own, asked));
  const Matrix u = weights.asDiagonal() * J;
  Evidence evidence{u.transpose() * J, u.transpose() * means.rightCols(1), 0, {}};
  if (record.known()) {
    evidence.told.push_back({{}, 1.0, 1.0, evidence.information});
    return evidence;
  }
  const Pairs pairs = pairs_of(record.blocks, u);
  std::vector<double> logs;
  for (const Noise& noise : noises) {
    auto [gram, log_determinant] = weigh(record.blocks, record.series->map, noise, means);
    const Eliminated eliminated = eliminate(gram, static_cast<int>(own) + asked);
    const double freedom = static_cast<double>(means.rows() - eliminated.rank);
    const double squares = std::max(gram(own + asked, own + asked), std::numeric_limits<double>::min());
    evidence.freedom = static_cast<int>(freedom);
    evidence.told.push_back({noise, 1.0, squares, {}});
    logs.push_back(std::log(noise.prior) -
                   0.5 * (log_determinant + eliminated.log_pivots + freedom * std::log(squares)));
  }
  normalise(evidence.told, logs);
  for (Told& one : evidence.told) one.variance = variance_of(pairs, one.noise);
  return evidence;
}

const Told& likeliest(const Evidence& evidence) {
  return *std::max_element(evidence.told.begin(), evidence.told.end(),
                           [](const Told& a, const Told& b) { return a.weight < b.weight; });
}

double variance_as_white(const Record& record, const Evidence& evidence) {
  if (record.known() || evidence.freedom < 1) return record.variance;
  double ratio = 0.0;
  const Matrix inverse = algebra::pseudo_inverse(evidence.information);
  for (const Told& one : evidence.told)
    ratio += one.weight * one.squares / evidence.freedom * (inverse * one.variance).trace();
  return record.variance * ratio / std::max((inverse * evidence.information).trace(), 1.0);
}

}  // namespace reye::fit
