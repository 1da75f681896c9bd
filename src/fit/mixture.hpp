#pragma once
#include <vector>

#include "fit/evidence.hpp"

/// Theta with the uncertainty of the noise: README (7).
namespace reye::fit {

/// Covariances of theta, equally likely, each under noises drawn for every series.
using Mixture = std::vector<Matrix>;
Mixture mixture_of(const std::vector<Scores>& scores, const std::vector<Belief>& beliefs);

Matrix mean_of(const Mixture& mixture);
/// What the error of theta[k] exceeds with probability 1 - p.
double quantile_of(const Mixture& mixture, int k, double p);

}  // namespace reye::fit
