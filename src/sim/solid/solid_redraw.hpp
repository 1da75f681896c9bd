#pragma once
#include <string>
#include <vector>

#include "sim/solid/solid_player.hpp"

namespace reye::sim {

/// Bodies with their shapes moved, and why each is to be remeshed; empty: it is not.
struct MovedSolids {
  SolidMeshes meshes;
  std::vector<std::string> reasons;
};

/// Remeshes the bodies that ask for it inside their worn skins, carries what contacts hold onto the new faces (sums are
/// kept) and solves the state again there, without slip and wear. A reason where a body cannot be remeshed, or the new
/// state not be solved. Observers get a record of each body, the log what changed; a change of pressures above 5 % of
/// their mean is a warning, too.
std::string redraw_bodies(const SolidProblem& problem, SolidPlayer& player, MovedSolids moved, const scene::Step& step,
                          const SolidObserver& observer, SolidRunState& state);

}  // namespace reye::sim
