#pragma once
#include <vector>

#include "fit/evidence.hpp"

/// Theta with the uncertainty of the noise: README (7).
namespace reye::fit {

/// Normal distributions of theta, equally likely, each under noises drawn for every series.
struct Mixture {
  std::vector<Vector> mean;  ///< from the place of linearisation
  std::vector<Matrix> covariance;
};

/// Empty where the information of a draw is singular: some parameter is not found.
Mixture mixture_of(const std::vector<Evidence>& series);

Vector mean_of(const Mixture& mixture);
/// Mean of the covariances plus covariance of the means.
Matrix covariance_of(const Mixture& mixture);
/// Where parameter k lies below with probability p.
double quantile_of(const Mixture& mixture, int k, double p);

}  // namespace reye::fit
