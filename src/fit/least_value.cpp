#include "fit/least_value.hpp"

#include <boost/math/tools/minima.hpp>
#include <limits>

namespace reye::fit {

double least_value(const std::function<double(double)>& f, double from, double to) {
  constexpr int half_of_digits = std::numeric_limits<double>::digits / 2;
  return boost::math::tools::brent_find_minima(f, from, to, half_of_digits).second;
}

}  // namespace reye::fit
