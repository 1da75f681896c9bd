#pragma once

/// Noise of a series up to its size.
namespace reye::fit {

/// Covariance of values over sigma^2: README (2). White noise has `order` -1.
struct Noise {
  int order = -1;          ///< of the Matern correlation: 0 exponential, 1 and 2 once and twice differentiable
  double length_mm = 0.0;  ///< correlation length
  double nugget = 1.0;     ///< variance of what each value has of its own
  double prior = 1.0;      ///< weight before the data are looked at
};

/// Correlation of two values at a distance [mm].
double correlation(const Noise& noise, double distance);

}  // namespace reye::fit
