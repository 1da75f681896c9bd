#include "fit/interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/decompose.hpp"

namespace reye::fit {

namespace {

constexpr double farthest = 6.9;  ///< a factor of a thousand

/// Score of theta[k] beside those of the other parameters, over its standard deviation.
double standard_score(const std::vector<Scores>& scores, const std::vector<Belief>& beliefs, int k) {
  const Eigen::Index p = scores.front().score.size();
  Matrix information = Matrix::Zero(p, p), variance = Matrix::Zero(p, p);
  Vector score = Vector::Zero(p);
  for (std::size_t s = 0; s < scores.size(); ++s) {
    information += scores[s].information;
    variance += variance_of(scores[s], beliefs[s]);
    score += scores[s].score;
  }
  const Vector along = algebra::solve_symmetric(information, Vector::Unit(p, k));
  return along.dot(score) / std::sqrt(along.dot(variance * along));
}

}  // namespace

std::vector<Scores> scores_at(const std::vector<Record>& records, const Model& model, const Unknowns& at) {
  std::vector<Scores> scores;
  for (const Record& record : records)
    scores.push_back(scores_of(record, columns_of(record, model, at), static_cast<int>(at.theta.size())));
  return scores;
}

double bound_of(const std::vector<Record>& records, const Model& model, const std::vector<Belief>& beliefs,
                const Unknowns& best, int k, double z, double deviation) {
  constexpr int most = 40;
  constexpr double growth = 1.5, close = 5e-3;  // of z
  const double sign = z < 0.0 ? -1.0 : 1.0, wanted = std::abs(z),
               nowhere = sign * std::numeric_limits<double>::infinity();
  Unknowns at = best;
  double low = 0.0, below = 0.0, high = 0.0, above = 0.0, x = std::min(wanted * deviation, farthest);
  for (int i = 0; i < most; ++i) {
    at.theta[k] = best.theta[k] + sign * x;
    const Found there = descend(records, model, at, k);
    if (!std::isfinite(there.S)) return nowhere;
    at = there.at;
    const double here = -sign * standard_score(scores_at(records, model, at), beliefs, k);
    if (std::isnan(here)) return nowhere;
    if (std::abs(here - wanted) < close * wanted) break;
    if (here < wanted && x >= farthest) return nowhere;
    (here < wanted ? low : high) = x;
    (here < wanted ? below : above) = here;
    const double part = (wanted - below) / (above - below);
    x = high > 0.0 ? low + (high - low) * std::clamp(part, 0.1, 0.9) : std::min(growth * x, farthest);
    if (high > 0.0 && high - low < close * high) break;
  }
  return best.theta[k] + sign * x;
}

}  // namespace reye::fit
