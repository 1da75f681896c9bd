#include "fit/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

std::vector<Evidence> evidence_at(const std::vector<Record>& records, const Model& model, const Unknowns& at) {
  std::vector<Evidence> all;
  for (const Record& record : records)
    all.push_back(evidence_of(record, columns_of(record, model, at), static_cast<int>(at.theta.size()),
                              candidates(record.blocks, record.series->map)));
  return all;
}

SeriesFit described(const Record& record, const Model& model, const Unknowns& at, const Evidence& evidence) {
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
  const Told& told = likeliest(evidence);
  const bool white = told.noise.order < 0;
  fit.scatter = record.known() ? rms(series.scatter)
                               : std::sqrt(told.squares / evidence.freedom * (told.noise.nugget + (white ? 0.0 : 1.0)));
  fit.correlation_mm = white ? 0.0 : told.noise.length_mm;
  return fit;
}

}  // namespace

Estimate estimate(const std::vector<Series>& series, const Model& model, const std::vector<std::string>& names,
                  const Vector& start) {
  (void)names;
  std::vector<Record> records = records_of(series);
  Found found = first_found(records, model, start);
  std::vector<Evidence> evidence = evidence_at(records, model, found.at);
  if (records.size() > 1) {
    for (std::size_t s = 0; s < records.size(); ++s) records[s].variance = variance_as_white(records[s], evidence[s]);
    found = descend(records, model, found.at);
    evidence = evidence_at(records, model, found.at);
  }
  const Mixture mixture = mixture_of(evidence);
  Estimate result;
  result.theta = found.at.theta;
  result.covariance = mean_of(mixture);
  result.converged = found.converged;
  result.low = result.high = found.at.theta;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (int k = 0; k < start.size(); ++k) {
    const double reach = quantile_of(mixture, k, 0.975);
    result.low[k] = bound_of(records, model, found.at, k, -reach).value_or(-infinite);
    result.high[k] = bound_of(records, model, found.at, k, reach).value_or(infinite);
  }
  for (std::size_t s = 0; s < records.size(); ++s)
    result.series.push_back(described(records[s], model, found.at, evidence[s]));
  return result;
}

Vector quick_theta(const std::vector<Series>& series, const Model& model, const Vector& start) {
  std::vector<Record> records = records_of(series);
  return first_found(records, model, start).at.theta;
}

}  // namespace reye::fit
