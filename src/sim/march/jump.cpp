#include "sim/march/jump.hpp"

#include <algorithm>
#include <numeric>

#include "base/formatted.hpp"
#include "sim/march/block.hpp"
#include "sim/march/block_play.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/march/level.hpp"
#include "sim/march/recording.hpp"
#include "sim/measure/correction.hpp"
#include "sim/measure/limit_measure.hpp"
#include "sim/measure/limits.hpp"

namespace reye::sim {

namespace {

double removed(const State& state) {
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  double volume = 0.0;
  for (const auto& c : state.solution.contacts) volume += sum(c.removed_secondary) + sum(c.removed_primary);
  return volume;
}

void tell(const Observer& observer, const BlockSpan& span, double cycle, const std::string& what) {
  if (!observer.log) return;
  const std::string text = base::formatted(", cycle %g, block of %g cycles: ", cycle, span.jump);
  observer.log("step \"" + span.step->name + '"' + text + what);
}

std::string estimated(double error) { return base::formatted("estimated error %.3g %%", 100.0 * error); }

/// The error that a block from `start` to `end` of its step may have.
double error_allowed(const Problem& problem, const scene::Step& step, const State& start, double end) {
  return allowed(problem.scene.limits, start.limit_measure, start.life_cycles, step, start.step_cycles, end);
}

/// One try of a block.
struct Trial {
  Outcome outcome;
  BlockPlay play;
  double cycles = 0.0;    ///< of the play
  bool too_long = false;  ///< by its error
  Recording rows, later;  ///< rows of the play, and of the cycles after it
};

/// Notes what a block from `start` to `end` has worn, for the next one to continue. Not where some of the contact
/// sticks: there the rate at a node changes too abruptly, since the edge recedes from node to node.
void note_wear(const Problem& problem, const State& start, double cycles, CourseOfWear course, State& end) {
  end.last_wear = {};
  const bool same_nodes =
      same_sizes(removed_volumes(start.solution.contacts), removed_volumes(end.solution.contacts));  // not renewed
  if (!same_nodes || !may_continue(problem.contacts) || !slips_throughout(start, end)) return;
  end.last_wear = {cycles, {}, start.limit_measure, std::move(course)};
  add_growth(end.last_wear.contacts, start.solution.contacts, end.solution.contacts);
}

/// The part of a span that a block's own play has, where cycles that level it are to follow.
BlockSpan before_levelling(BlockSpan span) {
  span.last = false;
  span.jump /= 1.0 + levelling;
  return span;
}

/// Plays a block by the two-step formula; empty where that does not serve. Where only the play shows that it does not,
/// what it cost is kept. Frames of increments are those of no formula.
std::optional<BlockPlay> continue_block(const Problem& problem, State& start, Cache& cache, const BlockSpan& block,
                                        const Observer& rows) {
  if (problem.scene.output.frames.every_increment) return std::nullopt;
  const auto formula = two_step(block.jump, start.last_wear.cycles);
  auto state = formula ? begun(start, *formula) : std::nullopt;
  if (!state) return std::nullopt;
  BlockPlay play = play_continued(problem, start, std::move(*state), *formula, cache, block, rows);
  if (play.serves || !play.failure.empty() || play.interrupted) return play;
  keep_counts(start, play.end.counts);
  return std::nullopt;
}

/// Plays a block to its end, before the cycles that level it where it is shown: continued where that serves, else in
/// halves.
BlockPlay play_to_end(const Problem& problem, State start, Cache& cache, const BlockSpan& span,
                      const Observer& observer, Recording& rows) {
  const auto block = span.level ? before_levelling(span) : span;
  auto play = continue_block(problem, start, cache, block, rows.observer(observer));
  if (!play) {
    rows = {};
    play = play_in_halves(problem, start, cache, block, observer, rows.observer(observer));
  }
  play->levels = span.level;
  return std::move(*play);
}

void play_trial(const Problem& problem, const State& start, Cache& cache, BlockSpan span, const Observer& observer,
                Trial& trial) {
  trial.play = play_to_end(problem, start, cache, span, observer, trial.rows);
  BlockPlay& play = trial.play;
  trial.outcome = {start, play.failure, play.interrupted};
  trial.outcome.state.counts = play.end.counts;
  if (!play.failure.empty() || play.interrupted) return;
  trial.too_long = play.error > error_allowed(problem, *span.step, start, start.step_cycles + span.jump);
  if (trial.too_long) return;
  trial.cycles = play.end.cycle - start.cycle;
  note_wear(problem, start, trial.cycles, std::move(play.course), play.end);
  if (play.levels)  // half of the block with its levelling comes a little later
    for (const auto measures = limit_measures(problem, *system_of(problem, play.end, cache), play.end);
         auto& [name, value] : play.middle)
      value += levelling * (measures.at(name) - value);
  span.moves = play.remesh_due || span.level;
  span.level = play.levels;
  span.extrapolated = play.extrapolated;
  trial.outcome =
      shaped(problem, std::move(play.end), cache, std::move(span), trial.cycles, trial.later.observer(observer));
  trial.outcome.middle = std::move(play.middle);
}

/// Reports a trial whose block is kept, and what the next block is to know of it. `state`: at the start of the block.
void accept_trial(const Problem& problem, const State& state, const BlockSpan& span, const Observer& observer,
                  Trial& trial) {
  State& end = trial.outcome.state;
  const double error = trial.play.error, before = removed(state), after = removed(end);
  const double share = after > 0.0 ? 1.0 - before / after : 0.0;
  trial.rows.play_back(observer, trial.play.correct);
  trial.later.play_back(observer);
  const double next = error_allowed(problem, *span.step, state, state.step_cycles + span.jump + span.jump);
  end.jump = next_jump(trial.cycles, share, error, next, state.jump_rate);
  end.jump_rate = share > 0.0 ? error / share : 0.0;
  const double kept = (1.0 - share) * (trial.play.slips_throughout ? 1.0 - share : 1.0);
  end.jump_error = std::max(kept * state.jump_error.value_or(0.0), error);
  if (end.last_wear.cycles > 0.0) end.jump = to_continue(end.jump, end.last_wear.cycles, *end.jump_error / next);
  tell(observer, span, state.cycle, estimated(error));
}

/// Shortens a block whose trial is not kept.
void refuse_trial(const Problem& problem, const Trial& trial, const Observer& observer, State& start, BlockSpan& span) {
  tell(observer, span, start.cycle,
       "refused: " + (trial.too_long ? estimated(trial.play.error) : trial.outcome.failure));
  ++start.counts.refused_blocks;
  const double permitted = error_allowed(problem, *span.step, start, start.step_cycles + span.jump);
  span.jump = std::max(unjumped, shortened(trial.too_long, permitted, trial.play.error) * span.jump);
  span.last = span.level = false;
}

/// Plays a block of one cycle, without a jump, in place of the one that was tried last.
Outcome play_one_cycle(const Problem& problem, const State& state, Cache& cache, BlockSpan span,
                       const Observer& observer) {
  const double tried = span.jump;
  span.jump = std::min(unjumped, span.jump);
  if (span.jump < tried) span.last = span.level = false;
  Outcome outcome = play_increments(problem, state, cache, span, observer);
  if (!outcome.failure.empty() || outcome.interrupted) return outcome;
  const bool first = state.step_cycles == 0.0;
  note_wear(problem, state, span.jump, std::move(outcome.worn), outcome.state);
  const bool continues = outcome.state.last_wear.cycles > 0.0;
  if (first) outcome.state.last_wear = {};
  outcome = end_block(problem, std::move(outcome.state), cache, span, observer);
  if (outcome.failure.empty() && !outcome.interrupted) {
    outcome.state.jump = after_one_cycle(tried, first, continues);
    outcome.state.jump_rate = 0.0;
    const double after = removed(outcome.state);
    if (state.jump_error && after > 0.0) outcome.state.jump_error = removed(state) / after * *state.jump_error;
  }
  return outcome;
}

}  // namespace

Outcome play_controlled(const Problem& problem, const State& state, Cache& cache, BlockSpan span,
                        const Observer& observer) {
  State start = state;
  const bool yields = std::any_of(problem.inputs.begin(), problem.inputs.end(), is_nonlinear);
  const bool by_itself = yields && start.step_cycles == 0.0;  // what yields does so in the first cycle
  while (span.jump > unjumped && !by_itself) {
    Trial trial;
    play_trial(problem, start, cache, span, observer, trial);
    keep_counts(start, trial.outcome.state.counts);
    if (trial.outcome.interrupted) return {std::move(start), {}, true};
    if (trial.outcome.failure.empty() && !trial.too_long) {
      accept_trial(problem, state, span, observer, trial);
      return std::move(trial.outcome);
    }
    refuse_trial(problem, trial, observer, start, span);
    const bool too_few = span.jump < fewest_tried && start.last_wear.cycles == 0.0;
    if (trial.too_long && (start.step_cycles == 0.0 || too_few)) break;
  }
  return play_one_cycle(problem, start, cache, span, observer);
}

}  // namespace reye::sim
