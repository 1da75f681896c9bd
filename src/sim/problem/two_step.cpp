#include "sim/problem/two_step.hpp"

namespace reye::sim {

std::optional<TwoStep> two_step(double cycles, double before) {
  constexpr double rounding = 1.1;  // blocks are stretched so far to end at a frame
  if (before <= 0.0 || cycles > rounding * most_ratio * before) return std::nullopt;
  return TwoStep{cycles / before};
}

double half_way(double before, double start, double end, double h_before, double h) {
  const double earlier = (start - before) / h_before, later = (end - start) / h;
  return 0.5 * (start + end) - 0.25 * h * h * (later - earlier) / (h + h_before);
}

}  // namespace reye::sim
