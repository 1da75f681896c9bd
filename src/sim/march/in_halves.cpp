#include <utility>

#include "sim/march/block.hpp"
#include "sim/march/block_play.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/march/recording.hpp"
#include "sim/measure/correction.hpp"
#include "sim/measure/figures.hpp"
#include "sim/measure/limit_measure.hpp"
#include "sim/reshape/shape.hpp"

namespace reye::sim {

namespace {

/// Both ends of a block, before its shape step.
struct TwicePlayed {
  State once, halves;
  std::vector<contact::ContactState> half_way;
  std::map<std::string, double> middle;  ///< measures of the limits after the first half
};

/// Notes the cost and the failure of a play; true: the attempt ends with it.
bool ends_attempt(const Outcome& outcome, BlockPlay& play) {
  play.end.counts = outcome.state.counts;
  play.failure = outcome.failure;
  play.interrupted = outcome.interrupted;
  return !outcome.failure.empty() || outcome.interrupted;
}

/// Plays two blocks of `span` one after the other, the second on the shape that the first has worn.
void play_halves(const Problem& problem, State start, Cache& cache, BlockSpan span, const Observer& observer,
                 TwicePlayed& attempt, BlockPlay& play) {
  BlockSpan first = span;
  first.last = first.level = false;
  Outcome outcome = play_increments(problem, std::move(start), cache, first, observer);
  if (ends_attempt(outcome, play)) return;
  span.ends = std::move(outcome.ends);
  if (problem.scene.shape) outcome = wear_down(problem, std::move(outcome.state), cache, first, {});
  if (ends_attempt(outcome, play)) return;
  play.remesh_due = outcome.remesh_due;
  attempt.half_way = outcome.state.solution.contacts;
  attempt.middle = limit_measures(problem, *system_of(problem, outcome.state, cache), outcome.state);
  outcome.state.step_cycles += span.jump;
  outcome = play_increments(problem, std::move(outcome.state), cache, span, observer);
  outcome.state.step_cycles -= span.jump;
  if (ends_attempt(outcome, play)) return;
  attempt.halves = std::move(outcome.state);
  play.course = std::move(outcome.worn);
}

/// Plays a block at once and in two halves.
TwicePlayed play_twice(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& coarse,
                       const Observer& fine, BlockPlay& play) {
  TwicePlayed attempt;
  span.remesh = false;  // nodes must be equal at both ends
  Outcome outcome = play_increments(problem, state, cache, span, coarse);
  if (ends_attempt(outcome, play)) return attempt;
  attempt.once = std::move(outcome.state);
  span.ends = std::move(outcome.ends);  // both plays are then equally fine, even where one was cut back
  span.jump *= 0.5;
  State start = state;
  start.counts = play.end.counts;
  start.recall = attempt.once.recall;
  play_halves(problem, std::move(start), cache, span, fine, attempt, play);
  return attempt;
}

}  // namespace

BlockPlay play_in_halves(const Problem& problem, const State& start, Cache& cache, BlockSpan span,
                         const Observer& observer, const Observer& rows) {
  BlockPlay play;
  TwicePlayed attempt = play_twice(problem, start, cache, span, quiet(observer), rows, play);
  if (!play.failure.empty() || play.interrupted) return play;
  const auto kept = system_of(problem, attempt.halves, cache);
  const Twice twice{start, attempt.once, attempt.half_way};
  play.slips_throughout = slips_throughout(start, attempt.halves);
  play.error = block_error(wear_difference(*kept, twice, attempt.halves), play.slips_throughout);
  const auto uncorrected = wear_of(problem, *kept, attempt.halves);
  const auto by_halves = limit_measures(problem, *kept, attempt.halves);
  extrapolate(*kept, twice, attempt.halves);
  // The first half has half of the error of both.
  for (const auto measures = limit_measures(problem, *kept, attempt.halves); auto& [name, value] : attempt.middle)
    value += 0.5 * (measures.at(name) - by_halves.at(name));
  play.middle = std::move(attempt.middle);
  play.correct = [before = uncorrected, after = wear_of(problem, *kept, attempt.halves), from = start.cycle,
                  cycles = span.jump](IncrementRecord& row) {
    add_wear(row, (row.cycle - from) / cycles, before, after);
  };
  play.extrapolated = true;
  play.end = std::move(attempt.halves);
  return play;
}

}  // namespace reye::sim
