#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// Takes the depth of every worn node from the shape: how far its place on X lies below the unworn outline, along that
/// outline's normal. `removed` of the contacts becomes that depth times the full nodal length, plus what waits in the
/// gap; so that no depth depends on the mesh on which it is evaluated.   (README, 7)
void measure_depths(const Problem& problem, State& state);

}  // namespace reye::sim
