#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/solid/solid_assembly.hpp"

namespace reye::sim {

/// A run of solids at the end of an increment.
struct SolidRunState {
  solver::SolidState solution;
  std::map<std::string, double> factors;  ///< of all histories
  int step = 0;
  double step_cycles = 0.0, cycle = 0.0;
  std::vector<double> energy_mJ;  ///< dissipated, per contact
  std::vector<double> energy_before_cycle_mJ, energy_last_cycle_mJ;
  Counts counts;
  std::vector<std::string> cutback_reasons;
  double balance = 0.0;                             ///< `imbalance_N` over the largest force
  double imbalance_N = 0.0, largest_force_N = 0.0;  ///< the largest so far
  double mortar_s = 0.0, interface_s = 0.0, factor_s = 0.0;
  int retained = 0;
};

}  // namespace reye::sim
