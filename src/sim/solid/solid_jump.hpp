#pragma once
#include "sim/solid/solid_player.hpp"

/// Blocks of cycles of solids: of a fixed number, or chosen by the error they make; as `march/fixed_jump` and
/// `march/jump` for the plane.
namespace reye::sim {

/// A block of `span.jump` cycles; where it fails, fewer are tried, and the state remembers how many worked.
SolidOutcome play_fixed_block(SolidPlayer& player, const SolidRunState& state, SolidSpan span,
                              const SolidObserver& observer);

/// A block of at most `span.jump` cycles, which continues the one before, or is played in halves, extrapolated, and
/// levelled where its end is shown. Where its error is too large for the step's tolerance, fewer cycles are tried.
SolidOutcome play_controlled_block(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& state,
                                   SolidSpan span, const SolidObserver& observer);

}  // namespace reye::sim
