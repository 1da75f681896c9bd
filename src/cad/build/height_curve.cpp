#include "cad/build/height_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reye::cad {

namespace {

/// Slope at an end by the parabola through three points, held back where it would overshoot.
double end_slope(double near_width, double far_width, double near_secant, double far_secant) {
  const double slope =
      ((2.0 * near_width + far_width) * near_secant - near_width * far_secant) / (near_width + far_width);
  if (slope * near_secant <= 0.0) return 0.0;
  if (near_secant * far_secant <= 0.0 && std::abs(slope) > 3.0 * std::abs(near_secant)) return 3.0 * near_secant;
  return slope;
}

}  // namespace

HeightCurve::HeightCurve(std::vector<double> arc, std::vector<double> height)
    : arc_(std::move(arc)), height_(std::move(height)), slope_(arc_.size(), 0.0) {
  const std::size_t last = arc_.size() - 1;
  const auto width = [&](std::size_t i) { return arc_[i + 1] - arc_[i]; };
  const auto secant = [&](std::size_t i) { return (height_[i + 1] - height_[i]) / width(i); };
  for (std::size_t i = 1; i < last; ++i) {
    if (secant(i - 1) * secant(i) <= 0.0) continue;
    const double before = 2.0 * width(i) + width(i - 1), after = width(i) + 2.0 * width(i - 1);
    slope_[i] = (before + after) / (before / secant(i - 1) + after / secant(i));
  }
  slope_[0] = last == 1 ? secant(0) : end_slope(width(0), width(1), secant(0), secant(1));
  slope_[last] =
      last == 1 ? secant(0) : end_slope(width(last - 1), width(last - 2), secant(last - 1), secant(last - 2));
}

std::array<double, 2> HeightCurve::at(double s) const {
  const auto above = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, s);
  const std::size_t i = static_cast<std::size_t>(above - arc_.begin()) - 1;
  const double width = arc_[i + 1] - arc_[i], u = std::clamp((s - arc_[i]) / width, 0.0, 1.0), v = 1.0 - u;
  const double rise = height_[i + 1] - height_[i];
  return {height_[i] + rise * u * u * (3.0 - 2.0 * u) + width * u * v * (v * slope_[i] - u * slope_[i + 1]),
          6.0 * u * v * rise / width + v * (1.0 - 3.0 * u) * slope_[i] + u * (1.0 - 3.0 * v) * slope_[i + 1]};
}

}  // namespace reye::cad
