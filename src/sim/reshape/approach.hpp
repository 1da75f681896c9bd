#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// Bodies apart and loaded by a force are moved along the first force, rigidly and by geometry alone, until the
/// first secondary node meets its facet.
void approach(const Problem& problem, State& state, const solver::System& system);

/// True when some support fixes or imposes the motion of a body along d.
bool held_along(const Problem& problem, const solver::System& system, int body, const Vec2& d);

}  // namespace reye::sim
