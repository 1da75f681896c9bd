#include "fit/mixture.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "fit/quantiles.hpp"

namespace reye::fit {

namespace {

constexpr int draws = 256;

/// Fractional parts of k times the powers of 1 / g, g^(d + 1) = g + 1: evenly spread in d dimensions for every count
/// (Roberts' generalisation of the golden ratio).
class Spread {
 public:
  explicit Spread(std::size_t dimensions) {
    double g = 2.0;
    for (int i = 0; i < 50; ++i) g = std::pow(1.0 + g, 1.0 / (static_cast<double>(dimensions) + 1.0));
    for (std::size_t i = 0; i < dimensions; ++i) step_.push_back(std::pow(g, -static_cast<double>(i + 1)));
  }
  double at(int k, std::size_t dimension) const {
    const double x = 0.5 + step_[dimension] * (k + 1);
    return x - std::floor(x);
  }

 private:
  std::vector<double> step_;
};

/// What chi^2 over its freedom takes, in `draws` steps of equal probability.
std::vector<double> spread_of_chi(int freedom) {
  std::vector<double> values(draws, 1.0);
  if (freedom <= 0) return values;
  for (int i = 0; i < draws; ++i) values[i] = chi_squared_quantile(freedom, (i + 0.5) / draws) / freedom;
  return values;
}

const Likely& drawn(const Belief& belief, double u) {
  for (const Likely& one : belief.noises) {
    u -= one.weight;
    if (u < 0.0) return one;
  }
  return belief.noises.back();
}

}  // namespace

Mixture mixture_of(const std::vector<Scores>& scores, const std::vector<Belief>& beliefs) {
  const Eigen::Index p = scores.front().score.size();
  const Spread spread(2 * scores.size());
  std::vector<std::vector<double>> chi;
  Matrix information = Matrix::Zero(p, p);
  for (const Belief& one : beliefs) chi.push_back(spread_of_chi(one.freedom));
  for (const Scores& one : scores) information += one.information;
  const Matrix inverse = algebra::solve_symmetric(information, Matrix::Identity(p, p));
  Mixture mixture;
  for (int k = 0; k < draws; ++k) {
    Matrix variance = Matrix::Zero(p, p);
    for (std::size_t s = 0; s < scores.size(); ++s) {
      const Likely& one = drawn(beliefs[s], spread.at(k, 2 * s));
      const double over = chi[s][static_cast<std::size_t>(spread.at(k, 2 * s + 1) * draws)];
      variance += one.variance / over * variance_of(scores[s].pairs, one.noise);
    }
    mixture.push_back(algebra::product(algebra::product(inverse, variance), inverse));
  }
  return mixture;
}

Matrix mean_of(const Mixture& mixture) {
  Matrix mean = Matrix::Zero(mixture.front().rows(), mixture.front().cols());
  for (const Matrix& one : mixture) mean += one / static_cast<double>(mixture.size());
  return mean;
}

double quantile_of(const Mixture& mixture, int k, double p) {
  double low = 0.0, high = 0.0;
  for (const Matrix& one : mixture) high = std::max(high, 10.0 * std::sqrt(one(k, k)));
  const double least = 1e-5 * high;
  while (high - low > least) {
    const double x = 0.5 * (low + high);
    double below = 0.0;
    for (const Matrix& one : mixture)
      below += normal_probability(x / std::sqrt(one(k, k))) / static_cast<double>(mixture.size());
    (below < p ? low : high) = x;
  }
  return 0.5 * (low + high);
}

}  // namespace reye::fit
