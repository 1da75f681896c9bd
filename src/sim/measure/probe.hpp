#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// Displacements of the scene's probes since the start, by name; `frame` is that of the state.
std::map<std::string, Vec2> probes(const Problem& problem, const State& state, const Frame& frame);

}  // namespace reye::sim
