#include "sim/solid/solid_state.hpp"

#include <numeric>

namespace reye::sim {

double energy_of(const SolidRunState& state, std::size_t contact) {
  return state.solution.wear[contact].frictional_work;
}

double removed_volume(const SolidRunState& state) {
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  double volume = 0.0;
  for (const auto& wear : state.solution.wear) volume += sum(wear.removed_secondary) + sum(wear.removed_primary);
  return volume;
}

}  // namespace reye::sim
