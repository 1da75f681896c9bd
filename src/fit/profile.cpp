#include "fit/profile.hpp"

#include <cmath>
#include <limits>

namespace reye::fit {

namespace {
constexpr double farthest = 6.9;  ///< a factor of a thousand
constexpr int most_trials = 20;
}  // namespace

double bound_of(const std::vector<Record>& records, const Model& model, const Found& found, int k, double z,
                double deviation) {
  const double sign = z < 0.0 ? -1.0 : 1.0, wanted = std::abs(z), best = found.at.theta[k];
  Unknowns at = found.at;
  const auto root = [&](double distance) {
    at.theta[k] = best + sign * distance;
    const Found there = descend(records, model, at, k);
    if (std::isfinite(there.S)) at = there.at;
    return std::sqrt(std::max(there.S - found.S, 0.0));
  };
  double low = 0.0, low_root = 0.0, high = std::numeric_limits<double>::infinity(), high_root = high;
  double x = std::min(wanted * deviation, farthest);
  for (int i = 0; i < most_trials; ++i) {
    const double r = root(x);
    if (std::abs(r - wanted) < 2e-3 * wanted) return best + sign * x;
    (r < wanted ? low : high) = x;
    (r < wanted ? low_root : high_root) = r;
    if (low >= farthest) return sign * std::numeric_limits<double>::infinity();
    if (std::isfinite(high) && std::isfinite(high_root)) {
      const double part = (wanted - low_root) / (high_root - low_root);
      x = low + (high - low) * std::min(std::max(part, 0.05), 0.95);
    } else if (std::isfinite(high)) {
      x = 0.5 * (low + high);
    } else {
      x = std::min(farthest, low * std::min(2.0, std::max(1.1, wanted / std::max(low_root, 1e-3 * wanted))));
    }
  }
  return best + sign * x;
}

}  // namespace reye::fit
