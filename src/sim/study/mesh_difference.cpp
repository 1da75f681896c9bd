#include "sim/study/mesh_difference.hpp"

#include "base/formatted.hpp"
#include "sim/study/known_orders.hpp"

namespace reye::sim {

void add_errors(const MeshDifference& apart, bool stick_edge, DiscretisationError& error) {
  error.order = !apart.wear ? traction_order : stick_edge ? stick_order : wear_order;
  error.surface = left_of_difference(error.order) * (apart.wear ? *apart.wear : *apart.traction);
  if (apart.peak) error.peak_pressure = left_of_difference(traction_order) * *apart.peak;
}

std::string in_words(const DiscretisationError& error) {
  if (!error.surface) return "no estimate of the mesh's error: " + error.reason;
  std::string words = base::formatted("estimated error of the mesh %.3g %%", 100.0 * *error.surface);
  if (!error.peak_pressure) return words;
  return words + base::formatted(", of the peak pressure %.3g %%", 100.0 * *error.peak_pressure);
}

}  // namespace reye::sim
