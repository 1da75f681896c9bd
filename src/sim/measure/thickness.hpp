#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// Opening of the present gap by a worn layer of one unit on X, per node of a contact's two sides: J over the stretch
/// of the surface, which is 1 / |F^-T N|. J and stretch are means over the cells and facets of a node. Empty where a
/// side has no finite strain.
struct LayerThickness {
  std::vector<double> secondary, primary;
};

LayerThickness layer_thickness(const Problem& problem, const State& state, const solver::System& system, int contact);

}  // namespace reye::sim
