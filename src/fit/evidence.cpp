#include "fit/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
  const int own = static_cast<int>(columns.cols()) - 1 - asked;
  const auto rows = static_cast<double>(means.rows());
  Evidence evidence;
  std::vector<double> logs;
  for (const Noise& noise : noises) {
    auto [gram, log_determinant] = weigh(record.blocks, record.series->map, noise, means);
    const Eliminated nuisances = eliminate(gram, own);
    Matrix rest = gram.bottomRightCorner(asked + 1, asked + 1);
    const Matrix A = rest.topLeftCorner(asked, asked);
    const Vector b = rest.topRightCorner(asked, 1);
    const Eliminated theta = eliminate(rest, asked);
    const double freedom = rows - nuisances.rank - theta.rank;
    const double squares = std::max(rest(asked, asked), std::numeric_limits<double>::min());
    evidence.told.push_back({noise, 1.0, squares, A, b});
    evidence.freedom = static_cast<int>(freedom);
    evidence.dependence = theta.rank;
    logs.push_back(std::log(noise.prior) -
                   0.5 * (log_determinant + nuisances.log_pivots + theta.log_pivots + freedom * std::log(squares)));
  }
  normalise(evidence.told, logs);
  if (record.known()) evidence.freedom = 0;
  return evidence;
}

void believe(Record& record, const Evidence& evidence) {
  if (record.known()) return;
  const auto best = std::max_element(evidence.told.begin(), evidence.told.end(),
                                     [](const Told& a, const Told& b) { return a.weight < b.weight; });
  record.noise = best->noise;
  record.variance = best->squares / std::max(evidence.freedom, 1);
}

}  // namespace reye::fit
