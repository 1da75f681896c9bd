#pragma once
#include "sim/solid/solid_state.hpp"

namespace reye::sim {

/// How far the pressures of a contact are from those that its points had before, or were given on a fresh mesh: root of
/// the mean square over the points that press before or after, over the mean. `before`: tractions [MPa] per point.
double pressure_change(const solver::SolidSolution& solved, const Points3& before, std::size_t contact);

}  // namespace reye::sim
