#include "fit/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompose.hpp"
#include "fit/mixture.hpp"
#include "fit/profile.hpp"
#include "fit/search.hpp"

namespace reye::fit {

namespace {

/// White noise as large as the values themselves spread: a first weight.
void assume_white(std::vector<Record>& records) {
  for (Record& record : records) {
    if (record.known()) continue;
    const Vector& value = record.series->value;
    record.noise = {};
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

std::vector<Evidence> evidence_at(const std::vector<Record>& records, const Model& model, const Unknowns& at,
                                  const std::vector<std::vector<Noise>>& noises) {
  std::vector<Evidence> all;
  for (std::size_t s = 0; s < records.size(); ++s)
    all.push_back(
        evidence_of(records[s], columns_of(records[s], model, at), static_cast<int>(at.theta.size()), noises[s]));
  return all;
}

SeriesFit described(const Record& record, const Model& model, const Unknowns& at) {
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
  const bool white = record.noise.order < 0;
  fit.scatter =
      record.known() ? rms(series.scatter) : std::sqrt(record.variance * (record.noise.nugget + (white ? 0.0 : 1.0)));
  fit.correlation_mm = white ? 0.0 : record.noise.length_mm;
  return fit;
}

}  // namespace

Estimate estimate(const std::vector<Series>& series, const Model& model, const std::vector<std::string>& names,
                  const Vector& start) {
  (void)names;
  std::vector<Record> records = records_of(series);
  Found found = first_found(records, model, start);
  std::vector<std::vector<Noise>> noises;
  for (const Record& record : records)
    noises.push_back(record.known() ? std::vector<Noise>{{}} : candidates(record.blocks, record.series->map));
  std::vector<Evidence> evidence;
  for (int i = 0; i < 3; ++i) {
    evidence = evidence_at(records, model, found.at, noises);
    const Vector before = found.at.theta;
    for (std::size_t s = 0; s < records.size(); ++s) {
      believe(records[s], evidence[s]);
      if (i > 0) continue;
    }
    found = descend(records, model, found.at);
    for (std::size_t s = 0; s < records.size(); ++s) {
      noises[s].clear();
      for (const Told& one : evidence[s].told) noises[s].push_back(one.noise);
    }
    if ((found.at.theta - before).cwiseAbs().maxCoeff() < 1e-3) break;
  }
  evidence = evidence_at(records, model, found.at, noises);
  const Mixture mixture = mixture_of(evidence);
  Estimate result{found.at.theta, covariance_of(mixture)};
  result.converged = found.converged;
  Mixture modal{{Vector::Zero(start.size())}, {}};
  const Matrix H = normal_at(records, model, found.at).H;
  const Matrix inverse = algebra::solve_symmetric(H, Matrix::Identity(H.rows(), H.cols()));
  result.low = result.high = found.at.theta;
  for (int k = 0; k < start.size(); ++k) {
    const double deviation = std::sqrt(inverse(k, k));
    result.low[k] = bound_of(records, model, found, k, quantile_of(mixture, k, 0.025) / deviation, deviation);
    result.high[k] = bound_of(records, model, found, k, quantile_of(mixture, k, 0.975) / deviation, deviation);
  }
  for (const Record& record : records) result.series.push_back(described(record, model, found.at));
  return result;
}

Vector quick_theta(const std::vector<Series>& series, const Model& model, const Vector& start) {
  std::vector<Record> records = records_of(series);
  return first_found(records, model, start).at.theta;
}

}  // namespace reye::fit
