#include "fit/covariance.hpp"

#include <cmath>

namespace reye::fit {

double correlation(const Noise& noise, double distance) {
  if (noise.order < 0) return distance == 0.0 ? 1.0 : 0.0;
  const double s = std::sqrt(2.0 * noise.order + 1.0) / noise.length_mm * distance, decay = std::exp(-s);
  if (noise.order == 0) return decay;
  return noise.order == 1 ? (1.0 + s) * decay : (1.0 + s + s * s / 3.0) * decay;
}

}  // namespace reye::fit
