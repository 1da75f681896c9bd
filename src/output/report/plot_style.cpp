#include <algorithm>
#include <array>
#include <cmath>

#include "base/formatted.hpp"
#include "output/report/plot.hpp"

namespace reye::output {

std::string scale_colour(double t) {
  static constexpr std::array<std::array<double, 3>, 6> stops{
      {{38, 38, 102}, {33, 90, 148}, {25, 140, 140}, {86, 170, 84}, {214, 160, 40}, {196, 68, 30}}};
  const double position = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * (stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const double f = position - static_cast<double>(i);
  const auto mixed = [&](std::size_t c) {
    return static_cast<unsigned>(std::lround((1.0 - f) * stops[i][c] + f * stops[i + 1][c])) & 255u;
  };
  return base::formatted("#%02x%02x%02x", mixed(0), mixed(1), mixed(2));
}

std::string line_colour(std::size_t i) {
  static constexpr std::array colours{"#1f5fa8", "#c8502d", "#2f8f5b", "#7a4fa3", "#b08900", "#4a5a6a"};
  return colours[i % colours.size()];
}

Line thinned(const Line& line, std::size_t limit) {
  const std::size_t count = line.x.size();
  if (count <= limit || limit < 4) return line;
  Line result = line;
  result.x.clear();
  result.y.clear();
  const auto keep = [&](std::size_t i) {
    result.x.push_back(line.x[i]);
    result.y.push_back(line.y[i]);
  };
  const std::size_t runs = limit / 2;
  for (std::size_t r = 0; r < runs; ++r) {
    const std::size_t begin = r * count / runs, end = (r + 1) * count / runs;
    const auto first = line.y.begin();
    const auto [low, high] =
        std::minmax_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end));
    const auto a = static_cast<std::size_t>(std::min(low, high) - first);
    const auto b = static_cast<std::size_t>(std::max(low, high) - first);
    keep(a);
    if (b != a) keep(b);
  }
  return result;
}

}  // namespace reye::output
