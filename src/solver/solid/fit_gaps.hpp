#pragma once
#include "solver/solid/increment_state.hpp"

namespace reye::solver {

/// After shapes have moved, or were meshed again: changes the fit of contacts whose wear is in their gaps so that on
/// the present shapes points that press touch, and no other penetrates. `state.u` belongs to the state's tractions.
void fit_gaps(const SolidSystem& system, SolidState& state);

}  // namespace reye::solver
