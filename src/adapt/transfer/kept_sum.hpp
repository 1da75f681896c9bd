#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

/// Sums of nodal shares that a transfer keeps.
namespace reye::adapt {

inline long double total_of(const std::vector<double>& values) {
  long double total = 0.0L;
  for (double v : values) total += v;
  return total;
}

inline long double magnitude_of(const std::vector<double>& values) {
  long double total = 0.0L;
  for (double v : values) total += std::abs(v);
  return total;
}

/// Restores the sum in proportion to the magnitude of each share: zero stays zero, and no share becomes negative.
inline void keep_sum(std::vector<double>& values, long double total) {
  const long double factor = (total - total_of(values)) / magnitude_of(values);
  for (double& v : values) v = static_cast<double>(v + factor * std::abs(v));
}

/// Volume, force ... per area.
inline std::vector<double> densities(const std::vector<double>& shares, const auto& area) {
  std::vector<double> density(shares.size(), 0.0);
  for (std::size_t j = 0; j < shares.size(); ++j)
    if (area[j] > 0.0) density[j] = shares[j] / area[j];
  return density;
}

/// Cuts values at zero where the values they come from have one sign: the coefficient of a control point may overshoot.
inline void keep_sign(std::vector<double>& values, const std::vector<double>& of) {
  const auto [least, most] = std::minmax_element(of.begin(), of.end());
  for (double& d : values) {
    if (*least >= 0.0) d = std::max(d, 0.0);
    if (*most <= 0.0) d = std::min(d, 0.0);
  }
}

}  // namespace reye::adapt
