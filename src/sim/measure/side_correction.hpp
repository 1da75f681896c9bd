#pragma once
#include <cstddef>
#include <vector>

#include "sim/problem/two_step.hpp"

/// The correction of the wear of one side of a contact, from playing a block once as a whole and once in two halves:
/// arrays over points, whatever the dimension.
namespace reye::sim {

/// Share of an error within the correction that is not counted, since the second-order rest is smaller than the
/// correction.
inline constexpr double settled = 0.5;

/// Elements between an edge that moved and the place where the correction is full.
inline constexpr int correction_reach = 3;

/// One side's removed volumes: before the block, after it as a whole, after its first half, after both.
struct SidePlays {
  const std::vector<double>&before, &once, &middle, &halves;

  /// Whether a point wore in one play and not in another.
  std::vector<char> passed() const;
  /// What both halves wore.
  std::vector<double> worn() const;
};

/// One side's removed volumes in a block that the two-step formula has continued. `growth`: in the block before.
struct ContinuedSide {
  std::vector<double> once;  ///< at its end, less what two halves would differ from it as a whole by
  std::vector<char> passed;  ///< whether a point wore in one of both blocks and not in the other
  /// Whether the formula serves: not where the side as a whole begins to wear, nor where a notable part of it stops,
  /// for it would keep the share that its block began with.
  bool serves = true;

  ContinuedSide(const TwoStep& formula, const std::vector<double>& growth, const std::vector<double>& start,
                const std::vector<double>& end);
};

/// From 0 to 1 how far a point is from those where something passed: `facets` lists the points of each facet.
template <class Facets>
std::vector<double> trust_by_distance(const Facets& facets, const std::vector<char>& passed) {
  std::vector<int> distance(passed.size(), correction_reach);
  for (std::size_t j = 0; j < passed.size(); ++j)
    if (passed[j]) distance[j] = 0;
  for (int turn = 1; turn < correction_reach; ++turn)
    for (const auto& nodes : facets) {
      int nearest = correction_reach;
      for (const int node : nodes) nearest = std::min(nearest, distance[static_cast<std::size_t>(node)]);
      if (nearest != turn - 1) continue;
      for (const int node : nodes) {
        int& there = distance[static_cast<std::size_t>(node)];
        there = std::min(there, turn);
      }
    }
  std::vector<double> share;
  for (const int d : distance) share.push_back(static_cast<double>(d) / correction_reach);
  return share;
}

/// The correction to the halves' values of one side; empty where none is possible. `trusted`: share per point;
/// `available`: what a point can get back.
std::vector<double> side_correction(const std::vector<double>& trusted, const std::vector<double>& once,
                                    const std::vector<double>& halves, const std::vector<double>& worn,
                                    const std::vector<double>& available);

/// sum_j |V_j - V'_j| over sum_j V_j, or the difference of the largest depths over the largest depth, whichever is
/// larger; of what is corrected the share `settled` is not counted. `area` per point; `deepest_once` and
/// `deepest_halves`: the largest depths of both plays.
double side_difference(const std::vector<double>& area, const std::vector<double>& trusted,
                       const std::vector<double>& once, const std::vector<double>& halves, double deepest_once,
                       double deepest_halves);

}  // namespace reye::sim
