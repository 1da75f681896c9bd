#include "fit/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/decompose.hpp"
#include "fit/interval.hpp"
#include "fit/mixture.hpp"
#include "fit/search.hpp"

namespace reye::fit {

namespace {

/// White noise as large as the values themselves spread: a first weight.
void assume_white(std::vector<Record>& records) {
  for (Record& record : records) {
    if (record.known()) continue;
    const Vector& value = record.series->value;
    record.variance = std::max((value.array() - value.mean()).square().mean(), 1e-30);
  }
}

/// White noise as large as what the fit leaves.
void weigh_white(std::vector<Record>& records, const Model& model, const Unknowns& at) {
  for (Record& record : records) {
    if (record.known()) continue;
    const double S = gram_of(record, residual_columns(record, model, at))(0, 0) * record.variance;
    record.variance = std::max(S / static_cast<double>(record.blocks.at.size()), 1e-30);
  }
}

Found first_found(std::vector<Record>& records, const Model& model, const Vector& start) {
  assume_white(records);
  Found found = search(records, model, {start, std::vector<Vec2>(records.size(), Vec2::Zero())});
  if (!std::isfinite(found.S)) return found;
  weigh_white(records, model, found.at);
  return descend(records, model, found.at);
}

/// What a series itself takes: its levels and derivatives, and where the model bends within a standard deviation.
Belief belief_at(const Record& record, const Model& model, const Unknowns& at) {
  const Matrix columns = columns_of(record, model, at);
  const int unknowns = record.shifts() + static_cast<int>(at.theta.size());
  const Belief first = belief_of(record, columns);
  if (record.known()) return first;
  const Scores scores = scores_of(record, columns, unknowns);
  const Matrix inverse = algebra::pseudo_inverse(scores.information);
  const Vector deviation = (inverse * variance_of(scores, first) * inverse).diagonal().cwiseSqrt();
  const Matrix bends = bends_of(record, model, at, deviation.cwiseMin(0.5));
  Matrix taken(columns.rows(), columns.cols() + bends.cols());
  taken << bends, columns;
  return belief_of(record, taken);
}

SeriesFit described(const Record& record, const Model& model, const Unknowns& at, const Belief& belief) {
  const Series& series = *record.series;
  SeriesFit fit;
  fit.shift = at.shift[record.number];
  fit.fitted = model(at.theta, record.number, fit.shift);
  const Vector level = level_of(record, model, at);
  fit.offset = level[0];
  fit.tilt = level.tail(2);
  for (std::size_t i = 0; i < series.at.size(); ++i)
    fit.fitted[static_cast<Eigen::Index>(i)] += level[0] + fit.tilt.dot(series.at[i]);
  const auto rms = [](const Vector& v) { return std::sqrt(v.squaredNorm() / static_cast<double>(v.size())); };
  fit.residual = rms(series.value - fit.fitted);
  const Likely& likely = belief.noises.front();
  const bool white = likely.noise.order < 0;
  fit.scatter =
      record.known() ? rms(series.scatter) : std::sqrt(likely.variance * (likely.noise.nugget + (white ? 0.0 : 1.0)));
  fit.correlation_mm = white ? 0.0 : likely.noise.length_mm;
  return fit;
}

}  // namespace

Estimate estimate(const std::vector<Series>& series, const Model& model, const std::vector<std::string>& names,
                  const Vector& start) {
  (void)names;
  std::vector<Record> records = records_of(series);
  Found found = first_found(records, model, start);
  std::vector<Belief> beliefs;
  for (const Record& record : records) beliefs.push_back(belief_at(record, model, found.at));
  if (records.size() > 1) {
    for (Record& record : records) {
      if (record.known()) continue;
      const Scores scores = scores_of(record, columns_of(record, model, found.at), static_cast<int>(start.size()));
      const Matrix inverse = algebra::pseudo_inverse(scores.information);
      record.variance *= (inverse * variance_of(scores, beliefs[record.number])).trace() /
                         std::max((inverse * scores.information).trace(), 1.0);
    }
    found = descend(records, model, found.at);
    for (const Record& record : records) beliefs[record.number] = belief_at(record, model, found.at);
  }
  const Mixture mixture = mixture_of(scores_at(records, model, found.at), beliefs);
  Estimate result;
  result.theta = found.at.theta;
  result.covariance = mean_of(mixture);
  result.converged = found.converged;
  result.low = result.high = found.at.theta;
  for (int k = 0; k < start.size(); ++k) {
    const double deviation = std::sqrt(result.covariance(k, k));
    const double z = quantile_of(mixture, k, 0.975) / deviation;
    result.low[k] = bound_of(records, model, beliefs, found.at, k, -z, deviation);
    result.high[k] = bound_of(records, model, beliefs, found.at, k, z, deviation);
  }
  for (std::size_t s = 0; s < records.size(); ++s)
    result.series.push_back(described(records[s], model, found.at, beliefs[s]));
  return result;
}

Vector quick_theta(const std::vector<Series>& series, const Model& model, const Vector& start) {
  std::vector<Record> records = records_of(series);
  return first_found(records, model, start).at.theta;
}

}  // namespace reye::fit
