#pragma once

/// Distributions of a fit.
namespace reye::fit {

double normal_probability(double z);                      ///< P(Z <= z)
double chi_squared_quantile(double freedom, double p);    ///< x of P(X <= x) = p
double fisher_tail(double of, double freedom, double F);  ///< P(X > F)
double chi_squared_tail(double freedom, double x);        ///< P(X > x)

}  // namespace reye::fit
