#include "sim/problem/block_wear.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace reye::sim {

bool same_sizes(const Volumes& a, const Volumes& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one[0].size() == other[0].size() && one[1].size() == other[1].size();
  });
}

Volumes worn_between(const Volumes& before, const Volumes& after) {
  Volumes worn = after;
  for (std::size_t c = 0; c < worn.size(); ++c)
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t j = 0; j < worn[c][side].size(); ++j) worn[c][side][j] -= before[c][side][j];
  return worn;
}

double worn_elsewhere(const Volumes& a, const Volumes& b) {
  double worst = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c)
    for (std::size_t side = 0; side < 2; ++side) {
      const auto &in_a = a[c][side], &in_b = b[c][side];
      const double all_a = std::accumulate(in_a.begin(), in_a.end(), 0.0);
      const double all_b = std::accumulate(in_b.begin(), in_b.end(), 0.0);
      if (!(all_a > 0.0 && all_b > 0.0)) continue;
      double apart = 0.0;
      for (std::size_t j = 0; j < in_a.size(); ++j) apart += std::abs(in_a[j] / all_a - in_b[j] / all_b);
      worst = std::max(worst, apart);
    }
  return worst;
}

void CourseOfWear::note(double progress, const Volumes& removed, const Volumes& at_start) {
  until.push_back({progress, worn_between(at_start, removed)});
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
