#include "sim/problem/block_wear.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace reye::sim {

namespace {

double worn_between(std::span<const double> before, std::span<const double> after) {
  double worn = 0.0;
  for (std::size_t j = 0; j < after.size(); ++j) worn += after[j] - before[j];
  return worn;
}

}  // namespace

bool same_sizes(const Volumes& a, const Volumes& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one[0].size() == other[0].size() && one[1].size() == other[1].size();
  });
}

double worn_elsewhere(const Volumes& start, const Volumes& end, const Volumes& after) {
  double worst = 0.0;
  for (std::size_t c = 0; c < end.size(); ++c)
    for (std::size_t side = 0; side < 2; ++side) {
      const auto of = [&](const Volumes& volumes) { return std::span<const double>(volumes[c][side]); };
      const double block = worn_between(of(start), of(end)), cycle = worn_between(of(end), of(after));
      if (!(block > 0.0 && cycle > 0.0)) continue;
      double apart = 0.0;
      for (std::size_t j = 0; j < of(end).size(); ++j)
        apart += std::abs((of(end)[j] - of(start)[j]) / block - (of(after)[j] - of(end)[j]) / cycle);
      worst = std::max(worst, apart);
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
