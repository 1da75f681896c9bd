#include "fit/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algebra/decompose.hpp"
#include "fit/quantiles.hpp"
#include "fit/shape_test.hpp"

namespace reye::fit {

namespace {

constexpr double doubtful = 1e-3;     ///< probability of a worse fit
constexpr double noticeable = 0.1;    ///< part of the depth of another shape
constexpr double independent = 1e-8;  ///< least singular value over the largest

std::string printed(const char* format, double a, double b = 0.0) {
  char text[100];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// What a series alone gives for theta, from the place of the fit.
struct Alone {
  Vector theta;
  Matrix covariance;
};
Alone alone(const Scores& scores, const Belief& belief) {
  const Matrix inverse = algebra::pseudo_inverse(scores.information);
  return {inverse * scores.score, inverse * variance_of(scores, belief) * inverse};
}

/// Probability that two series which agree differ as much, in the directions of theta that both determine.
double agreement(const Scores& a, const Scores& b, const Belief& of_a, const Belief& of_b) {
  const Matrix both =
      a.information * algebra::pseudo_inverse(a.information + b.information) * b.information;  // the parallel sum
  const auto [values, U, V] = algebra::singular_values(both);
  Eigen::Index rank = 0;
  while (rank < values.size() && values[rank] > independent * (a.information + b.information).norm()) ++rank;
  if (rank == 0) return 1.0;
  const Alone one = alone(a, of_a), other = alone(b, of_b);
  const Matrix along = U.leftCols(rank).transpose();
  const Vector apart = along * (one.theta - other.theta);
  const Matrix covariance = along * (one.covariance + other.covariance) * along.transpose();
  const Vector weighted = algebra::solve_symmetric(covariance, apart);
  const double distance = apart.dot(weighted);
  int freedom = 0;
  for (const Belief* belief : {&of_a, &of_b})
    if (belief->freedom > 0) freedom = freedom > 0 ? std::min(freedom, belief->freedom) : belief->freedom;
  const auto of = static_cast<double>(rank);
  return freedom > 0 ? fisher_tail(of, freedom, distance / of) : chi_squared_tail(of, distance);
}

std::string contradiction(const std::vector<Record>& records, const std::vector<Scores>& scores,
                          const std::vector<Belief>& beliefs) {
  const double pairs = 0.5 * static_cast<double>(records.size() * (records.size() - 1));
  double least = doubtful / pairs;
  std::string found;
  for (std::size_t i = 0; i < records.size(); ++i)
    for (std::size_t j = i + 1; j < records.size(); ++j) {
      const double p = agreement(scores[i], scores[j], beliefs[i], beliefs[j]);
      if (p >= least) continue;
      least = p;
      found = records[i].series->name + " and " + records[j].series->name +
              " contradict each other: what each alone gives differs by more than their intervals";
    }
  return found;
}

/// Chi^2 of all series with given scatter.
std::string excess(const std::vector<Record>& records, const Model& model, const Unknowns& at) {
  double squares = 0.0, worst = 0.0;
  int freedom = -static_cast<int>(at.theta.size());
  std::string name;
  for (const Record& record : records) {
    if (!record.known()) continue;
    const double S = gram_of(record, residual_columns(record, model, at))(0, 0);
    const auto count = static_cast<double>(record.series->value.size());
    squares += S;
    freedom += static_cast<int>(record.series->value.size()) - record.levels() - record.shifts();
    if (S / count > worst) name = record.series->name;
    worst = std::max(worst, S / count);
  }
  if (freedom < 1 || chi_squared_tail(freedom, squares) >= doubtful) return {};
  return "what is left is larger than the given scatter: chi^2 is " +
         printed("%.4g where %.4g is the 99.9 %% quantile", squares, chi_squared_quantile(freedom, 1.0 - doubtful)) +
         ", and " + name + " is left with " + printed("%.2g times its scatter", std::sqrt(worst));
}

}  // namespace

std::string doubt_of(const std::vector<Record>& records, const Model& model, const Unknowns& at,
                     const std::vector<Scores>& scores, const std::vector<Belief>& beliefs) {
  if (const std::string found = contradiction(records, scores, beliefs); !found.empty()) return found;
  if (const std::string found = excess(records, model, at); !found.empty()) return found;
  for (const Record& record : records) {
    if (record.known()) continue;
    const ShapeTest test = shape_test(record, model, at);
    if (test.probability < doubtful / static_cast<double>(records.size()) && test.part > noticeable)
      return record.series->name + " has another shape than what is computed: " +
             printed("%.0f %% of the depth is left, which is not noise", 100.0 * test.part);
  }
  return {};
}

}  // namespace reye::fit
