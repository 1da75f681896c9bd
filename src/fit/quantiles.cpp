#include "fit/quantiles.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <numbers>

namespace reye::fit {

double normal_probability(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double chi_squared_quantile(double freedom, double p) {
  return boost::math::quantile(boost::math::chi_squared(freedom), p);
}

double chi_squared_tail(double freedom, double x) {
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(freedom), x));
}

double fisher_tail(double of, double freedom, double F) {
  return boost::math::cdf(boost::math::complement(boost::math::fisher_f(of, freedom), F));
}

}  // namespace reye::fit
