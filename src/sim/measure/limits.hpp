#pragma once
#include <map>
#include <optional>
#include <string>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// The crossing of limits, and the end of a run by them.
namespace reye::sim {

/// What a run knows of its limits, by name: the cycle at which each was reached, its error where known, and the value
/// of its measure at the last block end. References into a state.
struct Lives {
  std::map<std::string, double>&cycles, &error, &measure;
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

/// Whether a limit that ends the run is still to be reached.
bool any_stop_ahead(const Problem& problem, const State& state);

/// Notes limits that a block crossed, between the values of their measures; true: one of them ends the run.
bool note_limits(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& measures,
                 const LimitSpan& span, const std::map<std::string, double>& middle, Lives lives);

/// The share of a block, between 0 and 1, up to the first limit that ends the run; `measures`: at its end.
std::optional<double> share_to_limit(const std::vector<scene::Limit>& limits,
                                     const std::map<std::string, double>& measures,
                                     const std::map<std::string, double>& middle, const Lives& lives);

/// The share of a block, between 0 and 1, up to the first limit that ends the run; empty where the block ends at it
/// or does not reach it. `middle`: measures half way through the block, where known.
std::optional<double> share_to_stop(const Problem& problem, const State& before, const State& after,
                                    const solver::System& system, const std::map<std::string, double>& middle);

/// Notes limits that were crossed in the last block, between the values of their measures; true: one of them ends the
/// run.
bool watch_limits(const Problem& problem, State& state, const solver::System& system, double cycle_before,
                  const std::map<std::string, double>& middle);

}  // namespace reye::sim
