#include <utility>

#include "sim/march/block.hpp"
#include "sim/march/block_play.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/measure/correction.hpp"
#include "sim/measure/figures.hpp"
#include "sim/measure/limit_measure.hpp"

namespace reye::sim {

std::optional<State> begun(const State& start, const TwoStep& formula) {
  std::optional<State> state = start;
  if (!add_share(state->solution.contacts, start.last_wear.contacts, formula.start())) return std::nullopt;
  return state;
}

BlockPlay play_continued(const Problem& problem, const State& start, State begun, const TwoStep& formula, Cache& cache,
                         BlockSpan span, const Observer& rows) {
  BlockPlay play;
  const double cycles = span.jump;
  const auto at_start = wear_of(problem, *system_of(problem, start, cache), start);
  const auto at_beginning = wear_of(problem, *system_of(problem, begun, cache), begun);
  span.jump *= formula.played();
  span.continued = Continued{start.cycle + cycles, &start.last_wear.course};
  span.remesh = false;
  const auto from = begun.solution.contacts;
  Outcome outcome = play_increments(problem, std::move(begun), cache, span, rows);
  play.failure = outcome.failure;
  play.interrupted = outcome.interrupted;
  play.end = std::move(outcome.state);
  if (!play.failure.empty() || play.interrupted) return play;
  play.course = std::move(outcome.worn);
  play.end.cycle = start.cycle + cycles;
  keep_still(start.solution.contacts, from, play.end.solution.contacts);
  const auto kept = system_of(problem, play.end, cache);
  play.slips_throughout = slips_throughout(start, play.end);
  const auto difference = continued_difference(*kept, start, formula, play.end);
  play.serves = difference && play.slips_throughout;
  if (!play.serves) return play;
  play.error = block_error(*difference, play.slips_throughout);
  play.middle = half_way(start.last_wear, start.limit_measure, limit_measures(problem, *kept, play.end), cycles);
  play.correct = [=, from = start.cycle](IncrementRecord& row) {
    add_wear(row, 1.0 - (row.cycle - from) / cycles, at_beginning, at_start);
  };
  return play;
}

}  // namespace reye::sim
