#pragma once
#include <array>
#include <vector>

namespace reye::cad {

/// Height and slope of a profile over arc length. Between its points it is a monotone cubic (Fritsch and Carlson 1980,
/// the slopes of PCHIP): smooth, so that a designed crown of few points gets no corners, and never above or below the
/// two points it lies between, so that a measured one gains no bumps. Beyond its ends it is zero.
class HeightCurve {
 public:
  /// Arc lengths must increase strictly.
  HeightCurve(std::vector<double> arc, std::vector<double> height);
  /// {height, slope} at arc length s, which is clamped to the range.
  std::array<double, 2> at(double s) const;
  const std::vector<double>& arc() const { return arc_; }

 private:
  std::vector<double> arc_, height_, slope_;
};

}  // namespace reye::cad
