#include "sim/measure/stick_zone.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/formatted.hpp"
#include "fit/least_value.hpp"

namespace reye::sim {

namespace {

constexpr double most_unresolved = 0.2;  ///< of the largest depth in the end, by one element of the stick zone

/// By how much the largest depth of the end is too large when a stick zone is `less` narrower than it was [mm].
double deeper(const StickZone& widest, double less, LimitDepth depth) {
  const double left = (widest.stick_mm - less) / widest.contact_mm;
  if (left <= 0.0) return std::numeric_limits<double>::infinity();
  return depth(left) / depth(widest.stick_mm / widest.contact_mm) - 1.0;
}

}  // namespace

double limit_depth_of_cylinders(double C) {
  const double x = std::sqrt(0.5 * (1.0 + C * C));
  return std::acosh(x / C) - x * std::sqrt(x * x - C * C);
}

double limit_depth_of_balls(double C) {
  const double approach = 4.0 / (3.0 * C) + 2.0 / 3.0 * C * C;
  const auto lowered = [&](double x) {
    const double above = approach - x * x;
    return 2.0 / std::numbers::pi * (above * std::asin(C / x) + C * std::sqrt(x * x - C * C)) - above;
  };
  return -fit::least_value(lowered, C, std::sqrt(approach));
}

std::optional<Warning> receding_stick(const std::string& about, const StickZone& now, StickZone& widest,
                                      double most_lost, double cycle, LimitDepth depth) {
  if (now.stick_mm > widest.stick_mm) widest = now;
  const double lost = widest.stick_mm - now.stick_mm;
  if (lost <= most_lost * widest.element_mm || widest.stick_mm >= widest.contact_mm) return std::nullopt;
  std::string estimate = "it wears without bound";
  if (now.stick_mm > 0.0)
    estimate = base::formatted("by the estimate for a round contact the largest depth is %.0f %% too large in the end",
                               100.0 * deeper(widest, lost, depth));
  const std::string words = base::formatted(
      "its stick zone has receded from %.3g to %.3g mm by cycle %g, and would keep its width under "
      "forces of one amplitude: %s; shorter elements hold its edge longer",
      widest.stick_mm, now.stick_mm, cycle, estimate.c_str());
  return Warning{"stick_zone", about, words, lost / widest.stick_mm};
}

std::optional<Warning> unresolved_stick(const std::string& about, const StickZone& widest, LimitDepth depth) {
  if (widest.stick_mm <= 0.0 || widest.stick_mm >= widest.contact_mm) return std::nullopt;
  const double error = deeper(widest, widest.element_mm, depth);
  if (error <= most_unresolved) return std::nullopt;
  double suited = widest.element_mm;
  while (deeper(widest, suited, depth) > 0.5 * most_unresolved) suited *= 0.9;
  const std::string by = std::isfinite(error) ? base::formatted("uncertain by %.0f %% in the end", 100.0 * error)
                                              : "unknown: without that element nothing would stick";
  return Warning{
      "stick_elements", about,
      base::formatted("its stick zone of %.3g mm has %.3g elements, and its edge is known to one of them: by "
                      "the estimate for a round contact the largest depth is %s; elements of %.2g mm would "
                      "leave a tenth",
                      widest.stick_mm, widest.stick_mm / widest.element_mm, by.c_str(), suited),
      widest.element_mm / widest.stick_mm};
}

}  // namespace reye::sim
