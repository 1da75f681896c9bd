#pragma once
#include "base/errors.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"

/// Sharp corners on secondary sides: their multiplier acts along the normal of one of the two facets, which the other
/// side need not face.
namespace reye::sim {

/// Contacts whose secondary side touches first with a corner that neither of its facets faces: refused, with the
/// remedy.
std::vector<base::Issue> corner_issues(const Problem& problem, const solver::System& system);

/// Warnings of corners that carry load along a normal other than that of the surface opposite: their forces may leave
/// its friction cone.
std::vector<Warning> corner_warnings(const solver::System& system, const State& state);

}  // namespace reye::sim
