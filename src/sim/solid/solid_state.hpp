#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/solid/solid_assembly.hpp"

namespace reye::sim {

/// A run of solids at the end of an increment. A value: copied, never half updated.
struct SolidRunState {
  solver::SolidState solution;
  std::vector<SkinPoints> points;         ///< per contact: what `solution` is numbered by
  SolidMeshes meshes;                     ///< of the bodies, as worn so far
  std::map<std::string, double> factors;  ///< of all histories
  int step = 0;
  double step_cycles = 0.0, cycle = 0.0;
  long step_blocks = 0;              ///< blocks done of this step
  double jump = 0.0;                 ///< cycles that the next block is tried with under a tolerance; 0: the first
  double jump_rate = 0.0;            ///< error of the last block over its share of all wear; 0: none
  double block_cycles = 0.0;         ///< where a fixed jump was too long in this step, the cycles that worked
  std::optional<double> jump_error;  ///< error of the blocks under a tolerance, as far as known
  std::vector<double> energy_last_cycle_mJ;  ///< dissipated in a cycle of the last block, per contact
  std::vector<std::vector<char>> slid;       ///< per contact: secondary points that slid in the last block
  std::map<std::string, double> life_cycles, life_error, limit_measure;  ///< as in State
  Counts counts;
  std::vector<std::string> cutback_reasons;
  double balance = 0.0;
  double mortar_s = 0.0, interface_s = 0.0, factor_s = 0.0, shape_s = 0.0;
  int retained = 0;
};

/// Work that friction has dissipated in a contact since the start [mJ].
double energy_of(const SolidRunState& state, std::size_t contact);

/// Volume that both sides of all contacts have lost since the start [mm^3].
double removed_volume(const SolidRunState& state);

}  // namespace reye::sim
