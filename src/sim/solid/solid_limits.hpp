#pragma once
#include <map>
#include <optional>
#include <string>

#include "sim/solid/solid_state.hpp"

/// Limits of the wear of solids: as `measure/limits` for the plane, by depth and volume of the faces.
namespace reye::sim {

/// The values of all limits, by name.
std::map<std::string, double> solid_limit_measures(const SolidProblem& problem, const solver::SolidSystem& system,
                                                   const SolidRunState& state);

/// Notes limits that the last block crossed; true: one of them ends the run.
bool watch_solid_limits(const SolidProblem& problem, const solver::SolidSystem& system, double cycle_before,
                        const std::map<std::string, double>& middle, SolidRunState& state);

/// The share of a block up to the first limit that ends the run; empty where the block ends at it or does not reach it.
std::optional<double> share_to_solid_stop(const SolidProblem& problem, const solver::SolidSystem& system,
                                          const SolidRunState& before, const SolidRunState& after,
                                          const std::map<std::string, double>& middle);

/// Whether a limit that ends the run is still to be reached.
bool solid_stop_ahead(const SolidProblem& problem, const SolidRunState& state);

}  // namespace reye::sim
