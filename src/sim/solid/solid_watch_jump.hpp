#pragma once
#include "sim/solid/solid_player.hpp"

namespace reye::sim {

/// At the end of the last step that jumps by blocks of one size, of `cycles`: as `march/watch_jump` for the plane.
void watch_jump(const SolidProblem& problem, SolidPlayer& player, SolidRunState& state, const scene::Step& step,
                double cycles, const SolidObserver& observer);

}  // namespace reye::sim
