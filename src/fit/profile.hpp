#pragma once
#include "fit/search.hpp"

/// An interval on the curve that a nonlinear model makes of it.
namespace reye::fit {

/// theta[k] where the least S of all others is z^2 above that at `found`, on the side of the sign of z (README (8)).
/// Infinite where it is not reached within a factor of a thousand.
double bound_of(const std::vector<Record>& records, const Model& model, const Found& found, int k, double z,
                double deviation);

}  // namespace reye::fit
