#pragma once
#include <functional>
#include <map>
#include <string>

#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"
#include "sim/problem/two_step.hpp"

/// The two ways to play a block under a tolerance.
namespace reye::sim {

/// A block under a tolerance at its end, before its shape step.
struct BlockPlay {
  State end;
  CourseOfWear course;
  double error = 0.0;                               ///< of this block, estimated
  std::map<std::string, double> middle;             ///< measures of the limits half way
  std::function<void(IncrementRecord&)> correct{};  ///< makes rows that were recorded in the play those of the block
  bool slips_throughout = false;
  bool serves = true;         ///< continued: all slips, and the wear of no side begins or stops
  bool levels = false;        ///< short cycles that level its end are to follow
  bool extrapolated = false;  ///< wear was corrected after it, but not the pressures
  bool remesh_due = false;    ///< a trigger fired half way, and was put off
  std::string failure;
  bool interrupted = false;
};

/// Plays a block once as a whole and once in two halves with the same increments, and extrapolates the halves
/// (`correction`); the error is the difference of both. `rows` observes the halves.
BlockPlay play_in_halves(const Problem& problem, const State& start, Cache& cache, BlockSpan span,
                         const Observer& observer, const Observer& rows);

/// The state that the two-step formula begins a block with; empty where some place would hold less than nothing.
std::optional<State> begun(const State& start, const TwoStep& formula);

/// Plays a block once, by the two-step formula, from `begun`; the error is what two halves of it would differ from it
/// as a whole by.
BlockPlay play_continued(const Problem& problem, const State& start, State begun, const TwoStep& formula, Cache& cache,
                         BlockSpan span, const Observer& rows);

}  // namespace reye::sim
