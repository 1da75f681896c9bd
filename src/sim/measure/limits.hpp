#pragma once
#include <map>
#include <optional>
#include <string>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// The crossing of limits, and the end of a run by them.
namespace reye::sim {

/// What a run knows of its limits, by name: the cycle at which each was reached, its error where known, the value of
/// its measure at the last block end, and what the measure grew by per cycle just before it. References into a state.
struct Lives {
  std::map<std::string, double>&cycles, &error, &measure, &rate;
};

/// The end of a block that another play is to have, for a limit in its midst.
struct LimitEnd {
  double share = 0.0;  ///< of the block that was played, between 0 and 1
  bool stop = false;   ///< the limit ends the run
  std::string limit;   ///< its name
};

/// The cycles of a block, and the error of its jump so far, where known.
struct LimitSpan {
  double before = 0.0, after = 0.0;
  std::optional<double> jump_error{};
};

/// The value that a limit's measure must not pass.
double bound_of(const scene::Limit& limit);

/// Whether a limit is reached at this value of its measure; a limit that ends the run already a thousandth before its
/// bound.
bool is_reached(const scene::Limit& limit, double measure);

/// What the log says of a block that is repeated, from `cycle` to such an end.
std::string block_repeated(const scene::Step& step, double cycle, double cycles, const LimitEnd& end);

/// Whether a limit is still to be reached.
bool any_limit_ahead(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& reached);

/// Notes limits that a block crossed, between the values of their measures; true: one of them ends the run. `middle`:
/// measures half way, where known.
bool note_limits(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& measures,
                 const LimitSpan& span, const std::map<std::string, double>& middle, Lives lives);

/// Where a block should end in place of its own end: at the first limit that ends the run, or at one whose crossing
/// inside the block is in doubt by more than `tolerance` of the life (0: none is), since its measure does not grow on
/// as it came, as where a coating is worn through. Empty where the block serves as it is. `measures`: at its end;
/// `again`: the block has been repeated already, so that the measure has changed its growth before the bound.
std::optional<LimitEnd> end_at_limit(const std::vector<scene::Limit>& limits,
                                     const std::map<std::string, double>& measures, const LimitSpan& span,
                                     const std::map<std::string, double>& middle, double tolerance, bool again,
                                     const Lives& lives);

/// As `end_at_limit`, of a block of a run.
std::optional<LimitEnd> block_end(const Problem& problem, const State& before, const State& after,
                                  const solver::System& system, const std::map<std::string, double>& middle,
                                  double tolerance, bool again);

/// Notes limits that were crossed in the last block, between the values of their measures; true: one of them ends the
/// run.
bool watch_limits(const Problem& problem, State& state, const solver::System& system, double cycle_before,
                  const std::map<std::string, double>& middle);

}  // namespace reye::sim
