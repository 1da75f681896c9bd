#pragma once
#include <cmath>
#include <random>
#include <vector>

#include "fit/estimate.hpp"

/// Scars that grow as a wearing cylinder's do, and what a profilometer makes of them.
namespace reye::support {

using base::Vec2;
using base::Vector;

enum class Scar { parabola, u, w };

/// Depth over the largest depth at xi = x / half width, 0 outside.
inline double form(Scar scar, double xi) {
  const double s = 1.0 - xi * xi;
  if (s <= 0.0) return 0.0;
  switch (scar) {
    case Scar::parabola:
      return s;
    case Scar::u:
      return 1.0 - std::pow(xi, 6);
    case Scar::w:
      return s * (0.45 + 1.6 * xi * xi) / 0.69;
  }
  return 0.0;
}

/// Depth of a scar worn for tau = coefficient x cycles: depth ~ tau^(2/3), width ~ tau^(1/3); 0.01 mm and 1 mm at 1.
inline double worn(Scar scar, double tau, double x) {
  return 0.01 * std::pow(tau, 2.0 / 3.0) * form(scar, x / (0.5 * std::cbrt(tau)));
}

/// Noise of unit standard deviation at evenly spaced places; `length` of its correlation [places], 0: white.
inline Vector noise(std::mt19937_64& random, int count, double length) {
  std::normal_distribution<double> normal;
  const double kept = length > 0.0 ? std::exp(-1.0 / length) : 0.0, fresh = std::sqrt(1.0 - kept * kept);
  Vector e(count);
  for (int i = 0; i < count; ++i) e[i] = i == 0 ? normal(random) : kept * e[i - 1] + fresh * normal(random);
  return e;
}

/// A profile of a scar as an instrument gives it: shifted by 0.03 mm, raised and tilted by some of its depth.
struct Measured {
  Scar scar = Scar::u;
  double noise = 0.05;           ///< over the largest depth
  double correlation = 0.0;      ///< over the width
  int count = 200;               ///< places over 2 widths
  double from = -1.0, to = 1.0;  ///< [width] about the middle
  double tau = 1.0;
};
inline fit::Series profile(std::mt19937_64& random, const Measured& m) {
  const double width = std::cbrt(m.tau), depth = worn(Scar::parabola, m.tau, 0.0);
  const double step = (m.to - m.from) * width / (m.count - 1);
  fit::Series series;
  series.name = "scar[0]";
  series.value = m.noise * depth * noise(random, m.count, m.correlation * width / step);
  for (int i = 0; i < m.count; ++i) {
    const double x = m.from * width + i * step;
    series.at.emplace_back(x, 0.0);
    series.value[i] += worn(m.scar, m.tau, x + 0.03) + 0.3 * depth + 0.2 * depth * x / width;
  }
  return series;
}

/// The model of profiles at given tau over a common factor exp(theta[0]).
inline fit::Model model_of(Scar scar, std::vector<fit::Series> series, std::vector<double> taus) {
  return [scar, series = std::move(series), taus = std::move(taus)](const Vector& theta, std::size_t s,
                                                                    const Vec2& shift) {
    const auto& at = series[s].at;
    Vector depth(static_cast<Eigen::Index>(at.size()));
    const double tau = taus[s] * std::exp(theta[0]);
    for (std::size_t i = 0; i < at.size(); ++i)
      depth[static_cast<Eigen::Index>(i)] = worn(scar, tau, at[i].x() + shift.x());
    return depth;
  };
}

}  // namespace reye::support
