#include "sim/problem/block_wear.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reye::sim {

bool same_sizes(const Volumes& a, const Volumes& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one[0].size() == other[0].size() && one[1].size() == other[1].size();
  });
}

double worn_elsewhere(const Volumes& start, const Volumes& end, const Volumes& after, double cycles) {
  double worst = 0.0;
  for (std::size_t c = 0; c < end.size(); ++c)
    for (std::size_t side = 0; side < 2; ++side) {
      double apart = 0.0, worn = 0.0;
      for (std::size_t j = 0; j < end[c][side].size(); ++j) {
        const double in_cycle = after[c][side][j] - end[c][side][j];
        apart += std::abs((end[c][side][j] - start[c][side][j]) / cycles - in_cycle);
        worn += in_cycle;
      }
      if (worn > 0.0) worst = std::max(worst, apart / worn);
    }
  return worst;
}

void CourseOfWear::note(double progress, Volumes removed, const Volumes& at_start) {
  for (std::size_t c = 0; c < removed.size(); ++c)
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t j = 0; j < removed[c][side].size(); ++j) removed[c][side][j] -= at_start[c][side][j];
  until.push_back({progress, std::move(removed)});
}

Volumes CourseOfWear::after(double progress, double factor) const {
  if (until.empty()) return {};
  const auto next = std::find_if(until.begin(), until.end(), [&](const auto& u) { return u.progress >= progress; });
  auto rest = until.back().volumes;
  if (next == until.end()) progress = until.back().progress;
  const auto& upper = next == until.end() ? until.back() : *next;
  const WornUntil* lower = next == until.begin() || next == until.end() ? nullptr : &*(next - 1);
  const double from = lower ? lower->progress : 0.0;
  const double share = upper.progress > from ? (progress - from) / (upper.progress - from) : 1.0;
  for (std::size_t c = 0; c < rest.size(); ++c)
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t j = 0; j < rest[c][side].size(); ++j) {
        const double before = lower ? lower->volumes[c][side][j] : 0.0;
        const double worn = before + share * (upper.volumes[c][side][j] - before);
        rest[c][side][j] = factor * (rest[c][side][j] - worn);
      }
  return rest;
}

}  // namespace reye::sim
