#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/solid/solid_assembly.hpp"

namespace reye::sim {

/// A run of solids at the end of an increment: everything that evolves, as a value. A member more is a member more of
/// its checkpoint, which does not compile without it (`output/solid/solid_archive.cpp`).
struct SolidRunState {
  solver::SolidState solution;  ///< empty before the first increment
  Touchable touchable;          ///< nodes that the condensation keeps
  /// The increment that led here, of which frames and summaries are made; in it `solution` once more.
  std::optional<solver::SolidSolution> solved;
  std::map<std::string, double> factors;  ///< of all histories
  std::map<std::string, double> held;     ///< of all histories when this play of the step began
  int step = 0;
  int step_plays = 0;  ///< whole plays of this step
  int increment = 0;   ///< whole increments of this play; 0 between plays
  double cycle = 0.0;
  std::vector<double> energy_mJ;  ///< dissipated, per contact
  std::vector<double> energy_before_cycle_mJ, energy_last_cycle_mJ;
  std::vector<Warning> warnings;  ///< found in the run
  Counts counts;
  std::vector<std::string> cutback_reasons;
  double balance = 0.0;
  int retained = 0;
  double mortar_s = 0.0, interface_s = 0.0, factor_s = 0.0;  ///< CPU seconds of this process; in no checkpoint
};

/// The state before the first step.
SolidRunState initial_solid_state(const SolidProblem& problem);

/// How often a step is played: once for each cycle, or once where it counts none.
int plays_of(const scene::Step& step);

/// Whether the run ends with this state.
bool at_end(const SolidProblem& problem, const SolidRunState& state);

}  // namespace reye::sim
