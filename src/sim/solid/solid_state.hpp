#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/problem/block_wear.hpp"
#include "sim/problem/watch.hpp"
#include "sim/solid/solid_assembly.hpp"

namespace reye::sim {

/// A run of solids at the end of an increment: everything that evolves, as a value. A member more is a member more of
/// its checkpoint, which does not compile without it (`output/solid/solid_archive.cpp`).
struct SolidRunState {
  solver::SolidState solution;     ///< empty before the first increment
  std::vector<SkinPoints> points;  ///< per contact: what `solution` is numbered by
  SolidMeshes meshes;              ///< of the bodies, as worn so far
  SolidMeshes born;                ///< as they were drawn, or remeshed last
  Touchable touchable;             ///< nodes that the condensation keeps
  /// The increment that led here, of which frames and summaries are made; in it `solution` once more.
  std::optional<solver::SolidSolution> solved;
  bool fitted = true;  ///< its points and gaps are those of `meshes`: not where a run has ended on these
  std::map<std::string, Vec3> probes;         ///< displacements at the end of the run
  std::map<std::string, double> factors;      ///< of all histories
  std::vector<contact::SkinWear> block_wear;  ///< per contact: when this block began
  BlockWear<contact::SkinWear> last_wear;     ///< of the last block under a tolerance in this step
  int step = 0;
  int increment = 0;         ///< whole increments of this play; 0 between plays
  double step_cycles = 0.0;  ///< cycles done of this step
  double cycle = 0.0;
  long step_blocks = 0;              ///< blocks done of this step
  double jump = 0.0;                 ///< cycles that the next block is tried with under a tolerance; 0: the first
  double jump_rate = 0.0;            ///< error of the last block over its share of all wear; 0: none
  bool levels_at_once = true;        ///< one play is tried to level the next block that is shown on the way
  double share_per_cycle = 0.0;      ///< `pending_share` that a cycle of the last block added
  double block_cycles = 0.0;         ///< where a fixed jump was too long in this step, the cycles that worked
  std::optional<double> jump_error;  ///< error of the blocks under a tolerance, as far as known
  std::vector<double> energy_last_cycle_mJ;  ///< dissipated in a cycle of the last block, per contact
  std::vector<std::vector<char>> slid;       ///< per contact: secondary points that slid in the last block
  std::map<std::string, double> life_cycles, life_error, limit_measure, limit_rate;  ///< as in State
  std::vector<StickZone> widest_stick;                                               ///< per contact
  std::vector<Warning> warnings;                                                     ///< found in the run
  Counts counts;
  std::vector<std::string> cutback_reasons;
  double balance = 0.0;                             ///< `imbalance_N` over the largest force
  double imbalance_N = 0.0, largest_force_N = 0.0;  ///< the largest so far
  int retained = 0;
  double mortar_s = 0.0, interface_s = 0.0, factor_s = 0.0, shape_s = 0.0;  ///< CPU of this process; in no checkpoint
};

/// The state before the first step.
SolidRunState initial_solid_state(const SolidProblem& problem);

/// Cycles still to be played in a step, and whether it is over.
double cycles_left(const scene::Step& step, const SolidRunState& state);
bool is_over(const scene::Step& step, const SolidRunState& state);

/// Whether the run ends with this state: its last step is over, or a limit that ends it has been reached.
bool at_end(const SolidProblem& problem, const SolidRunState& state);

/// Work that friction has dissipated in a contact since the start [mJ].
double energy_of(const SolidRunState& state, std::size_t contact);

/// Volume that both sides of all contacts have lost since the start [mm^3].
double removed_volume(const SolidRunState& state);

}  // namespace reye::sim
