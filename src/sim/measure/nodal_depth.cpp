#include "sim/measure/nodal_depth.hpp"

#include <algorithm>

namespace reye::sim {

std::vector<double> at_nodes(const mortar::Surface& surface, std::vector<double> coefficients) {
  for (const auto& [a, b, c] : surface.facets)
    if (c >= 0) coefficients[c] = 0.25 * (coefficients[a] + 2.0 * coefficients[c] + coefficients[b]);
  return coefficients;
}

std::vector<double> depths(const mortar::Surface& surface, const std::vector<double>& removed) {
  std::vector<double> depth(removed.size());
  for (std::size_t j = 0; j < depth.size(); ++j) depth[j] = removed[j] / surface.area[j];
  return at_nodes(surface, std::move(depth));
}

double deepest(const mortar::Surface& surface, const std::vector<double>& removed) {
  const auto depth = depths(surface, removed);
  return depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
}

}  // namespace reye::sim
