#include "fit/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompose.hpp"
#include "fit/alone.hpp"
#include "fit/doubts.hpp"
#include "fit/interval.hpp"
#include "fit/mixture.hpp"
#include "fit/refusal.hpp"
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
  Unknowns first{start, {}};
  for (const Record& record : records) first.shift.push_back(record.series->near);
  Found found = search(records, model, first);
  if (!std::isfinite(found.S)) return found;
  weigh_white(records, model, found.at);
  return descend(records, model, found.at);
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

/// Series weighed by what they inform: README (3).
void weigh_by_information(std::vector<Record>& records, const std::vector<Scores>& scores,
                          const std::vector<Belief>& beliefs) {
  for (Record& record : records) {
    if (record.known()) continue;
    const Scores& own = scores[record.number];
    const Matrix inverse = algebra::pseudo_inverse(own.information);
    const double rank = (inverse * own.information).trace();
    if (rank > 0.5) record.variance *= (inverse * variance_of(own, beliefs[record.number])).trace() / rank;
  }
}

/// Intervals and covariance, or why there are none.
void bound(Estimate& result, const std::vector<Record>& records, const Model& model, const Found& found,
           const std::vector<Belief>& beliefs, const std::vector<std::string>& names) {
  constexpr double upper = 0.975, farthest = 6.9;  // the latter is a factor of a thousand
  const Mixture mixture = mixture_of(scores_at(records, model, found.at), beliefs);
  result.covariance = mean_of(mixture);
  result.low = result.high = result.theta;
  for (int k = 0; k < result.theta.size(); ++k) {
    const double deviation = std::sqrt(result.covariance(k, k));
    if (!(deviation < farthest)) {
      result.refused = unbounded(names[k], true);
      return;
    }
    const double z = quantile_of(mixture, k, upper) / deviation;
    result.low[k] = bound_of(records, model, beliefs, found.at, k, -z, deviation);
    result.high[k] = bound_of(records, model, beliefs, found.at, k, z, deviation);
    for (const bool below : {true, false})
      if (!std::isfinite(below ? result.low[k] : result.high[k])) {
        result.refused = unbounded(names[k], below);
        return;
      }
  }
}

}  // namespace

Estimate estimate(const std::vector<Series>& series, const Model& model, const std::vector<std::string>& names,
                  const Vector& start) {
  Estimate result;
  result.refused = refusal_of(series, start.size());
  if (!result.refused.empty()) return result;
  std::vector<Record> records = records_of(series);
  Found found = first_found(records, model, start);
  if (!std::isfinite(found.S)) {
    result.refused = "what is computed is not finite where the search begins";
    return result;
  }
  result.refused = undetermined(scores_at(records, model, found.at), names);
  if (!result.refused.empty()) return result;
  const std::vector<Alone> alone = each_alone(records, model, found.at);
  std::vector<Belief> beliefs;
  for (const Alone& one : alone) beliefs.push_back(one.belief);
  if (records.size() > 1) {
    weigh_by_information(records, scores_at(records, model, found.at), beliefs);
    found = descend(records, model, found.at);
  }
  result.theta = found.at.theta;
  result.converged = found.converged;
  result.poor = doubt_of(records, model, found.at, alone);
  bound(result, records, model, found, beliefs, names);
  if (!result.refused.empty() && !result.poor.empty()) result.refused = result.poor + "; " + result.refused;
  if (!result.refused.empty()) return result;
  for (const Record& record : records)
    result.series.push_back(described(record, model, found.at, beliefs[record.number]));
  return result;
}

Vector quick_theta(const std::vector<Series>& series, const Model& model, const Vector& start) {
  std::vector<Record> records = records_of(series);
  return first_found(records, model, start).at.theta;
}

}  // namespace reye::fit
