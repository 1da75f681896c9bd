#include "output/picture/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include "base/formatted.hpp"

namespace reye::output {

namespace {

/// The round step nearest above range / target.
double nice_step(double range, int target) {
  const double rough = range / target;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough * (1.0 - 1e-9)) return factor * power;
  return 10.0 * power;
}

std::string fixed(double value, int decimals) {
  return (value < 0.0 ? "−" : "") + base::formatted("%.*f", decimals, std::abs(value));
}

}  // namespace

Range widened(Range range) {
  if (!std::isfinite(range.low) || !std::isfinite(range.high) || range.low > range.high) return {0.0, 1.0};
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.width() > 1e-12 * size && range.width() > 1e-300) return range;
  const double half = size > 1e-290 ? 0.1 * size : 1.0;
  return {range.low - half, range.high + half};
}

Range rounded_out(Range range, int target) {
  range = widened(range);
  const double step = nice_step(range.width(), target);
  return {std::floor(range.low / step + 1e-9) * step, std::ceil(range.high / step - 1e-9) * step};
}

Ticks nice_ticks(double low, double high, int target) {
  const Range range = widened({low, high});
  const double step = nice_step(range.width(), target);
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  Ticks ticks;
  const int magnitude = static_cast<int>(std::floor(std::log10(size)));
  if (magnitude >= 6 || magnitude <= -4) ticks.exponent = magnitude;
  const double unit = std::pow(10.0, ticks.exponent);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step / unit) + 1e-9)));
  const double first = std::ceil(range.low / step - 1e-9), last = std::floor(range.high / step + 1e-9);
  for (double k = first; k <= last; k += 1.0) {
    ticks.values.push_back(k == 0.0 ? 0.0 : k * step);
    ticks.labels.push_back(fixed(ticks.values.back() / unit, decimals));
  }
  return ticks;
}

}  // namespace reye::output
