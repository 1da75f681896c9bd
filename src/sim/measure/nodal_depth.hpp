#pragma once
#include <vector>

#include "mortar/surface.hpp"

namespace reye::sim {

/// The values at the nodes of Bernstein coefficients per node and control point: (a + 2c + b) / 4 in the middle of a
/// curve.
std::vector<double> at_nodes(const mortar::Surface& surface, std::vector<double> coefficients);

/// Depth at each surface node [mm]; its coefficients are removed volume over full nodal length on X.
std::vector<double> depths(const mortar::Surface& surface, const std::vector<double>& removed);

/// The largest depth.
double deepest(const mortar::Surface& surface, const std::vector<double>& removed);

}  // namespace reye::sim
