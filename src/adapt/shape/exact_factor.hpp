#pragma once
#include <cmath>
#include <limits>

namespace reye::adapt {

/// The factor theta near 1 for which strip(theta), nearly proportional to theta, is exactly `volume` > 0, by the secant
/// method down to round-off; NaN when there is none.
template <class Strip>
double exact_factor(double volume, Strip strip) {
  double theta = 1.0, f = strip(theta) - volume, slope = f + volume;
  if (!(slope > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 30 && f != 0.0; ++i) {
    const double next = theta - f / slope, g = strip(next) - volume;
    if (!(std::abs(g) < std::abs(f))) break;  // round-off reached
    slope = (g - f) / (next - theta);
    theta = next;
    f = g;
  }
  return std::abs(f) <= 1e-12 * volume ? theta : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace reye::adapt
