#pragma once
#include <string>
#include <vector>

#include "fit/series.hpp"

/// Parameters of a model from what was measured, with their intervals.
namespace reye::fit {

/// A series as fitted.
struct SeriesFit {
  double offset = 0.0;  ///< at the instrument's origin
  Vec2 tilt{0.0, 0.0};
  Vec2 shift{0.0, 0.0};
  Vector fitted;                ///< model + offset + tilt at the places
  double residual = 0.0;        ///< root mean square
  double scatter = 0.0;         ///< standard deviation of one value, given (root mean square) or found
  double correlation_mm = 0.0;  ///< of the residuals; 0: white
};

struct Estimate {
  Vector theta;
  Matrix covariance;
  Vector low, high;  ///< 95 % interval of each parameter
  std::vector<SeriesFit> series;
  bool converged = false;
  std::string poor;     ///< empty, or one sentence why the fit is poor
  std::string refused;  ///< not empty: what the data do not determine, one sentence naming parameters and why; then the
                        ///< rest is not to be used
};

/// Generalised least squares with noise of unknown size and correlation: README (1) to (9). `names`: of the parameters,
/// for messages. `start`: a first guess of theta.
Estimate estimate(const std::vector<Series>& series, const Model& model, const std::vector<std::string>& names,
                  const Vector& start);

/// Only theta, quickly (white noise, no interval), for decisions while a run is played.
Vector quick_theta(const std::vector<Series>& series, const Model& model, const Vector& start);

}  // namespace reye::fit
