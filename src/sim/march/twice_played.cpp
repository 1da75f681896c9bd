#include "sim/march/twice_played.hpp"

#include <utility>

#include "sim/march/block.hpp"
#include "sim/measure/limit_measure.hpp"
#include "sim/reshape/shape.hpp"

namespace reye::sim {

namespace {

/// Notes the cost and the failure of a play; true: the attempt ends with it.
bool ends_attempt(const Outcome& outcome, TwicePlayed& attempt) {
  attempt.counts = outcome.state.counts;
  attempt.failure = outcome.failure;
  attempt.interrupted = outcome.interrupted;
  return !outcome.failure.empty() || outcome.interrupted;
}

/// Plays two blocks of `span` one after the other, the second on the shape that the first has worn.
void play_halves(const Problem& problem, State start, Cache& cache, BlockSpan span, const Observer& observer,
                 TwicePlayed& attempt) {
  BlockSpan first = span;
  first.last = first.level = false;
  Outcome outcome = play_increments(problem, std::move(start), cache, first, observer);
  if (ends_attempt(outcome, attempt)) return;
  span.ends = std::move(outcome.ends);
  if (problem.scene.shape) outcome = wear_down(problem, std::move(outcome.state), cache, first, {});
  if (ends_attempt(outcome, attempt)) return;
  attempt.remesh_due = outcome.remesh_due;
  attempt.half_way = outcome.state.solution.contacts;
  attempt.middle = limit_measures(problem, *system_of(problem, outcome.state, cache), outcome.state);
  outcome.state.step_cycles += span.jump;
  outcome = play_increments(problem, std::move(outcome.state), cache, span, observer);
  outcome.state.step_cycles -= span.jump;
  if (!ends_attempt(outcome, attempt)) attempt.halves = std::move(outcome.state);
}

}  // namespace

TwicePlayed play_twice(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& coarse,
                       const Observer& fine) {
  TwicePlayed attempt;
  span.remesh = false;  // nodes must be equal at both ends
  Outcome outcome = play_increments(problem, state, cache, span, coarse);
  if (ends_attempt(outcome, attempt)) return attempt;
  attempt.once = std::move(outcome.state);
  span.ends = std::move(outcome.ends);  // both plays are then equally fine, even where one was cut back
  span.jump *= 0.5;
  State start = state;
  start.counts = attempt.counts;
  start.recall = attempt.once.recall;
  play_halves(problem, std::move(start), cache, span, fine, attempt);
  return attempt;
}

}  // namespace reye::sim
