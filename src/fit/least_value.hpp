#pragma once
#include <functional>

namespace reye::fit {

/// The least value of a function with one minimum in [from, to], by Brent's method to half of the digits of the place.
double least_value(const std::function<double(double)>& f, double from, double to);

}  // namespace reye::fit
