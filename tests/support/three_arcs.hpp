#pragma once
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace reye::support {

/// A circle of radius 10 as curves 2, 8 and 9 between points of their own.
inline std::string three_arcs(double from_deg) {
  std::string text = "Point(100) = {0, 0, 0};\n";
  const int curves[] = {2, 8, 9};
  for (int k = 0; k < 3; ++k) {
    const double angle = (from_deg + 120.0 * k) * std::numbers::pi / 180.0;
    char point[120];
    std::snprintf(point, sizeof point, "Point(%d) = {%.17g, %.17g, 0};\n", 101 + k, 10.0 * std::cos(angle),
                  10.0 * std::sin(angle));
    text += point;
  }
  for (int k = 0; k < 3; ++k)
    text += "Circle(" + std::to_string(curves[k]) + ") = {" + std::to_string(101 + k) + ", 100, " +
            std::to_string(101 + (k + 1) % 3) + "};\n";
  return text;
}

}  // namespace reye::support
