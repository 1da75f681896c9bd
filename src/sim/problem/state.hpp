#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/problem/block_wear.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/recall.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/watch.hpp"
#include "solver/system.hpp"

namespace reye::sim {

/// Number of cut-backs whose reasons a state keeps; further ones are only counted, so that it does not grow without
/// bound.
inline constexpr long told_cutbacks = 100;

/// Everything that changes in a run, and nothing else. A value: copied, never half updated.
struct State {
  // Compiled once: every file that holds one would else compile them.
  State();
  State(const State&);
  State(State&&) noexcept;
  State& operator=(const State&);
  State& operator=(State&&) noexcept;
  ~State();

  double cycle = 0.0;
  int step = 0;
  double step_cycles = 0.0;    ///< cycles done of this step
  long step_blocks = 0;        ///< blocks done of this step
  double jump = 0.0;           ///< cycles that the next block is tried with under a tolerance; 0: the first
  double jump_rate = 0.0;      ///< error of the last block under a tolerance over its share of all wear; 0: none
  double block_cycles = 0.0;   ///< where a fixed jump was too long in this step, the cycles that worked; 0: none was
  double flow = 0.0;           ///< share of all plastic strain that the last block added
  bool levels_at_once = true;  ///< one play is tried to level the next block that is shown on the way
  BlockWear<contact::ContactState> last_wear;  ///< of the last block under a tolerance in this step
  std::optional<double> jump_error;            ///< error of the blocks under a tolerance, as far as known
  std::map<std::string, double> factors;       ///< of every history
  std::vector<body::ShapePtr> shapes;
  solver::SolverState solution;
  Recall recall;
  /// Per support of the scene: its x, y and rotation when the reference of its body was last renewed, from which its
  /// columns count. Empty: no reference was renewed.
  std::vector<std::array<double, 3>> renewed_at;
  /// Per body: displacement of its nodes when its reference was last renewed; empty: it never was.
  std::vector<base::Points> displaced;
  bool approached = false;                      ///< bodies apart have been moved until they touch
  std::map<std::string, double> life_cycles;    ///< limits reached so far
  std::map<std::string, double> life_error;     ///< error of those by the cycle jump, where known [cycles]
  std::map<std::string, double> limit_measure;  ///< value of each limit's measure at the last block end
  std::map<std::string, double> limit_rate;     ///< its growth per cycle just before that
  std::optional<double> small_strain_error;     ///< largest estimate so far where small strain was chosen
  std::vector<Warning> warnings;                ///< found in the run
  std::vector<ContactWatch> watch;              ///< observations of each contact
  std::vector<BondTraction> bonds;              ///< largest tractions of each bond
  Counts counts;
  bool shown = false;                        ///< this state is a frame already: none is written twice
  std::vector<std::string> cutback_reasons;  ///< of the first `told_cutbacks`
};

/// The state before the first step.
State initial_state(const Problem& problem);

}  // namespace reye::sim
