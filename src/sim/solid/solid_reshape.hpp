#pragma once
#include <map>
#include <string>

#include "adapt/solid/solid_relocation.hpp"
#include "sim/solid/solid_player.hpp"

namespace reye::sim {

/// What shape steps keep from one to the next, per body: the factor by which the inside follows.
using SolidRelocations = std::map<std::size_t, adapt::SolidRelocationCache>;

/// Largest worn depth that waits in the gaps, over the size of the facets there.
double pending_share(const solver::SolidSystem& system, const SolidRunState& state);

/// Whether `remesh.every_blocks` asks for fresh meshes after the block that has been played last.
bool remesh_due(const SolidProblem& problem, const SolidRunState& state);

/// Moves the worn faces by the volumes that wait in the gaps, exactly, and makes the equations of the new shapes; the
/// strips are entered in the ledger. Bodies whose elements have lost their shape are remeshed, those that are about to
/// where the run continues, and all in contact where that is due. A reason where a body cannot follow.
std::string reshape_bodies(const SolidProblem& problem, SolidPlayer& player, SolidRelocations& relocations,
                           const scene::Step& step, const SolidObserver& observer, SolidRunState& state);

}  // namespace reye::sim
