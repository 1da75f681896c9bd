#pragma once
#include "sim/problem.hpp"
#include "sim/records.hpp"
#include "sim/state.hpp"

namespace reye::sim {

/// Displacements of the scene's probes since the start, by name; `frame` is that of the state.
std::map<std::string, Vec2> probes(const Problem& problem, const State& state, const Frame& frame);

}  // namespace reye::sim
