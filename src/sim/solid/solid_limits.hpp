#pragma once
#include <map>
#include <optional>
#include <string>

#include "sim/measure/limits.hpp"
#include "sim/solid/solid_state.hpp"

/// Limits of the wear of solids: as `measure/limits` for the plane, by depth and volume of the faces.
namespace reye::sim {

/// The values of all limits, by name.
std::map<std::string, double> solid_limit_measures(const SolidProblem& problem, const solver::SolidSystem& system,
                                                   const SolidRunState& state);

/// Notes limits that the last block crossed; true: one of them ends the run.
bool watch_solid_limits(const SolidProblem& problem, const solver::SolidSystem& system, double cycle_before,
                        const std::map<std::string, double>& middle, SolidRunState& state);

/// As `end_at_limit`, of a block of a run.
std::optional<LimitEnd> solid_block_end(const SolidProblem& problem, const solver::SolidSystem& system,
                                        const SolidRunState& before, const SolidRunState& after,
                                        const std::map<std::string, double>& middle, double tolerance, bool again);

}  // namespace reye::sim
