#include "sim/measure/side_correction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reye::sim {

std::vector<char> SidePlays::passed() const {
  std::vector<char> flags(halves.size(), 0);
  for (std::size_t j = 0; j < flags.size(); ++j) {
    const bool first = middle[j] > before[j], second = halves[j] > middle[j], whole = once[j] > before[j];
    flags[j] = first != second || first != whole;
  }
  return flags;
}

std::vector<double> SidePlays::worn() const {
  std::vector<double> w(halves.size());
  for (std::size_t j = 0; j < w.size(); ++j) w[j] = halves[j] - before[j];
  return w;
}

/// Growth of a rate from block to block beyond which wear begins at a point.
constexpr double beginning = 2.0;
constexpr double notable = 0.05;    ///< of the growth of a side
constexpr double round_off = 1e-9;  ///< of the growth at a point

ContinuedSide::ContinuedSide(const TwoStep& formula, const std::vector<double>& growth,
                             const std::vector<double>& start, const std::vector<double>& end)
    : once(end), passed(end.size(), 0) {
  double grown = 0.0, stopped = 0.0, worn = 0.0;
  for (std::size_t j = 0; j < end.size(); ++j) {
    const double now = end[j] - start[j], share = formula.start() * growth[j];
    const bool stands = growth[j] > 0.0 && now - share <= round_off * growth[j];
    const bool begins = now > beginning * formula.ratio * growth[j];
    grown += growth[j];
    worn += now;
    if (stands) stopped += growth[j];
    // Where wear begins, its rate at the end serves for the block: what is too much there is lacking beside. Where it
    // has stopped, all that the block began with is too much.
    once[j] -= growth[j] > 0.0 && !stands ? formula.two_halves_apart(growth[j], now) : now;
    passed[j] = begins || stands;
  }
  serves = stopped <= notable * grown && (grown > 0.0 || worn <= 0.0);
}

std::vector<double> side_correction(const std::vector<double>& trusted, const std::vector<double>& once,
                                    const std::vector<double>& halves, const std::vector<double>& worn,
                                    const std::vector<double>& available) {
  std::vector<double> d(halves.size());
  double share = 0.0, left = 0.0;
  for (std::size_t j = 0; j < d.size(); ++j) {
    d[j] = trusted[j] * (halves[j] - once[j]);
    left += halves[j] - once[j] - d[j];
    share += (1.0 - trusted[j]) * worn[j];
  }
  if (left != 0.0 && share <= 0.0) return {};
  double cut = 0.0, gained = 0.0;
  for (std::size_t j = 0; j < d.size(); ++j) {
    const double wanted = d[j] + (share > 0.0 ? left * (1.0 - trusted[j]) * worn[j] / share : 0.0);
    d[j] = std::max(wanted, -available[j]);
    cut += d[j] - wanted;
    gained += std::max(d[j], 0.0);
  }
  if (cut > gained) return {};
  if (cut > 0.0)
    for (double& v : d)
      if (v > 0.0) v *= 1.0 - cut / gained;
  return d;
}

double side_difference(const std::vector<double>& area, const std::vector<double>& trusted,
                       const std::vector<double>& once, const std::vector<double>& halves, double deepest_once,
                       double deepest_halves) {
  const double volume = std::accumulate(halves.begin(), halves.end(), 0.0);
  if (volume <= 0.0) return 0.0;
  double apart = 0.0;
  std::size_t lowest = 0;
  for (std::size_t j = 0; j < halves.size(); ++j) {
    apart += (1.0 - settled * trusted[j]) * std::abs(halves[j] - once[j]);
    if (halves[j] * area[lowest] > halves[lowest] * area[j]) lowest = j;
  }
  const double deeper = std::abs(deepest_halves - deepest_once) / deepest_halves;
  return std::max(apart / volume, (1.0 - settled * trusted[lowest]) * deeper);
}

}  // namespace reye::sim
