#include "fit/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "fit/quantiles.hpp"
#include "fit/shape_test.hpp"

namespace reye::fit {

namespace {

constexpr double doubtful = 1e-3;  ///< probability of a worse fit
constexpr double surely = 0.99, large = 0.1;
constexpr double far_reaching = 0.4;  ///< correlation length over the width of the scar
constexpr double noticeable = 0.05;   ///< part of the depth that is left
constexpr double independent = 1e-8;  ///< least singular value over the largest

std::string printed(const char* format, double a, double b = 0.0) {
  char text[100];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// How likely the noise is correlated over more than a length.
double far(const Belief& belief, double length_mm) {
  double likely = 0.0;
  for (const Likely& one : belief.noises)
    if (one.noise.order >= 0 && one.noise.length_mm > length_mm) likely += one.weight;
  return likely;
}

/// Of theta that a series alone gives.
Matrix covariance_of(const Alone& one) {
  const Matrix inverse = algebra::pseudo_inverse(one.scores.information);
  return algebra::product(algebra::product(inverse, variance_of(one.scores, one.belief)), inverse);
}

/// Probability that two series which agree differ as much, in the directions of theta that both determine.
double agreement(const Alone& a, const Alone& b) {
  const Matrix &A = a.scores.information, &B = b.scores.information;
  const Matrix both = algebra::product(algebra::product(A, algebra::pseudo_inverse(A + B)), B);  // the parallel sum
  const auto [values, U, V] = algebra::singular_values(both);
  Eigen::Index rank = 0;
  while (rank < values.size() && values[rank] > independent * (A + B).norm()) ++rank;
  if (rank == 0) return 1.0;
  const Matrix along = U.leftCols(rank).transpose();
  const Vector differ = a.at.theta - b.at.theta;
  const Vector apart = along * differ;
  const Matrix sum = covariance_of(a) + covariance_of(b);
  const Matrix covariance = algebra::product_transposed(algebra::product(along, sum), along);
  const Vector weighted = algebra::solve_symmetric(covariance, apart);
  const double distance = apart.dot(weighted);
  int freedom = 0;
  for (const Belief* belief : {&a.belief, &b.belief})
    if (belief->freedom > 0) freedom = freedom > 0 ? std::min(freedom, belief->freedom) : belief->freedom;
  const auto of = static_cast<double>(rank);
  return freedom > 0 ? fisher_tail(of, freedom, distance / of) : chi_squared_tail(of, distance);
}

std::string contradiction(const std::vector<Record>& records, const std::vector<Alone>& alone) {
  const double pairs = 0.5 * static_cast<double>(records.size() * (records.size() - 1));
  double least = doubtful / pairs;
  std::string found;
  for (std::size_t i = 0; i < records.size(); ++i)
    for (std::size_t j = i + 1; j < records.size(); ++j) {
      const double p = agreement(alone[i], alone[j]);
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

std::string doubt_of(const std::vector<Record>& records, const Model& model, const Unknowns& together,
                     const std::vector<Alone>& alone) {
  if (const std::string found = contradiction(records, alone); !found.empty()) return found;
  if (const std::string found = excess(records, model, together); !found.empty()) return found;
  for (const Record& record : records) {
    if (record.known()) continue;
    const Alone& own = alone[record.number];
    const ShapeTest test = shape_test(record, model, own.at, own.taken, noticeable);
    const bool wide = far(own.belief, far_reaching * test.width) > surely && test.part > large;
    const bool other = test.probability < doubtful / static_cast<double>(records.size());
    if (test.part > noticeable && (wide || other))
      return record.series->name + " has another shape than what is computed: " +
             printed("%.0f %% of its depth is left and is not noise", 100.0 * test.part);
  }
  return {};
}

}  // namespace reye::fit
