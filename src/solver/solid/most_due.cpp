#include "solver/solid/most_due.hpp"

#include <algorithm>

namespace reye::solver {

namespace {

constexpr double share_of_the_most = 0.5;

}  // namespace

void keep_the_most_due(const std::vector<std::vector<double>>& due,
                       const std::vector<std::vector<contact::SkinStatus>>& now,
                       std::vector<std::vector<contact::SkinStatus>>& fresh) {
  double most = 0.0;
  const auto each_change = [&](auto visit) {
    for (std::size_t c = 0; c < fresh.size(); ++c)
      for (std::size_t j = 0; j < fresh[c].size(); ++j)
        if (fresh[c][j] != now[c][j]) visit(fresh[c][j], now[c][j], due[c][j]);
  };
  each_change([&](auto&, auto, double by) { most = std::max(most, by); });
  each_change([&](auto& next, auto before, double by) {
    if (by < share_of_the_most * most) next = before;
  });
}

}  // namespace reye::solver
