#include "solver/solid/most_due.hpp"

#include <algorithm>
#include <cmath>

namespace reye::solver {

namespace {

using contact::SkinStatus;

constexpr double share_of_the_most = 0.5;

/// How far the trial value is beyond the limit between two states of a point [MPa].
double excess(const contact::SkinNode& node, const contact::SkinFrame& frame, double mu, double stiffness,
              SkinStatus now, SkinStatus fresh) {
  const double p = contact::pressure(node, frame);
  if (now == SkinStatus::open || fresh == SkinStatus::open) return std::abs(p - stiffness * node.gap);
  return std::abs(contact::trial(node, frame, stiffness).norm() - mu * std::max(0.0, p));
}

}  // namespace

void keep_the_most_due(const SolidSystem& system, std::span<const contact::SkinPlace> places,
                       const std::vector<std::vector<contact::SkinNode>>& nodes, const std::vector<double>& friction,
                       const std::vector<std::vector<SkinStatus>>& now, std::vector<std::vector<SkinStatus>>& fresh) {
  double most = 0.0;
  const auto each_change = [&](auto visit) {
    for (std::size_t c = 0; c < places.size(); ++c)
      for (int j = 0; j < places[c].count(); ++j)
        if (fresh[c][j] != now[c][j] && places[c].carries[j])
          visit(fresh[c][j], now[c][j],
                excess(nodes[c][j], places[c].frame[j], friction[c], system.contacts[c].stiffness[j], now[c][j],
                       fresh[c][j]));
  };
  each_change([&](SkinStatus&, SkinStatus, double due) { most = std::max(most, due); });
  each_change([&](SkinStatus& next, SkinStatus before, double due) {
    if (due < share_of_the_most * most) next = before;
  });
}

}  // namespace reye::solver
