#include "sim/march/jump.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "base/formatted.hpp"
#include "sim/march/block.hpp"
#include "sim/march/recording.hpp"
#include "sim/march/twice_played.hpp"
#include "sim/measure/correction.hpp"
#include "sim/measure/figures.hpp"
#include "sim/measure/limit_measure.hpp"
#include "sim/measure/limits.hpp"
#include "sim/reshape/balance.hpp"

namespace reye::sim {

namespace {

constexpr double aim = 0.85;        ///< share of the allowed error at which the next block aims
constexpr double most_early = 1.5;  ///< times the tolerance, for a block far from the end of its step
constexpr double most_cut = 0.3;    ///< of the cycles from one block to the next
constexpr double most_steeper =
    1.5;  ///< growth of a block's error per share that is allowed for from one block to the next
constexpr double edge_share = 1.25;  ///< times the difference where some sticks

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

/// Difference of the pressures of a state from those held before it, of the worst contact, in the mean
/// (`pressure_jump`); unbounded where a contact that has worn carries nothing at the ends of its cycles, which says
/// nothing of the pressures inside them.
double pressure_change(const Problem& problem, const State& state, Cache& cache,
                       const std::vector<HeldTraction>& before) {
  const auto kept = system_of(problem, state, cache);
  const auto& system = *kept;
  double largest = 0.0;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& contact = state.solution.contacts[c];
    const auto& pressed = before[c].normal;
    const bool open = std::none_of(pressed.begin(), pressed.end(), [](double force) { return force > 0.0; });
    if (open && contact.law_volume > 0.0) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, pressure_jump(system.contacts[c], contact, before[c]));
  }
  return largest;
}

/// Plays short cycles after a block, without extrapolation: unevenness left by the correction or a fresh mesh is worn
/// level before it is shown or jumped from. Their wear waits in the gap. Each has half of the remaining cycles: the
/// first remove the unevenness, the last wear so little that pressures follow the stroke. At the end of a step, whose
/// pressures are shown, they halve until pressures repeat.
Outcome level(const Problem& problem, Outcome outcome, Cache& cache, BlockSpan span, const Observer& observer) {
  constexpr int fewest_cycles = 2, most_cycles = 8;
  constexpr double repeated = 0.01;  // of the mean pressure, from one levelling cycle to the next
  const bool last = span.last;
  const auto play = [&](double jump, bool ends) {
    span.jump = jump;
    span.last = last && ends;
    outcome = play_increments(problem, std::move(outcome.state), cache, span, observer);
    return outcome.failure.empty() && !outcome.interrupted;
  };
  double left = span.jump;
  bool level = !last;
  for (int k = fewest_cycles; k <= most_cycles; ++k) {
    const auto before = held_tractions(*system_of(problem, outcome.state, cache), outcome.state);
    left *= 0.5;
    if (!play(left, false)) return outcome;
    if (level) break;
    level = k > fewest_cycles && pressure_change(problem, outcome.state, cache, before) < repeated;
  }
  play(left, true);
  return outcome;
}

/// Adds to a row of the halves its share of the correction at the end of the block.
void correct(IncrementRecord& row, double share, const IncrementRecord& before, const IncrementRecord& after) {
  const auto add = [share](auto& to, const auto& from, const auto& end) {
    to.depth_max_secondary_mm += share * (end.depth_max_secondary_mm - from.depth_max_secondary_mm);
    to.depth_max_primary_mm += share * (end.depth_max_primary_mm - from.depth_max_primary_mm);
    to.energy_mJ += share * (end.energy_mJ - from.energy_mJ);
  };
  add(row, before, after);
  for (std::size_t c = 0; c < row.contacts.size(); ++c) add(row.contacts[c], before.contacts[c], after.contacts[c]);
}

/// The error that a block from `start` to `end` of its step may have.
double error_allowed(const Problem& problem, const scene::Step& step, const State& start, double end) {
  return allowed(problem.scene.limits, start.limit_measure, start.life_cycles, step, start.step_cycles, end);
}

/// One try of a block.
struct Trial {
  Outcome outcome;
  double error = 0.0;     ///< estimated; 0 where it was not played to its end
  bool too_long = false;  ///< by its error
  bool slips_throughout = false;
  Recording rows, later;                   ///< rows of the halves, and of the cycles after them
  IncrementRecord uncorrected, corrected;  ///< wear at the end of the halves
};

/// The cycles of a block without those that level it.
double without_levelling(const BlockSpan& span) { return span.level ? span.jump / (1.0 + levelling) : span.jump; }

/// The extrapolated end of a block of `cycles` on its new shape: levelled where it is shown, and where a body is to be
/// remeshed, for which pressures must be those of the shape. Levelling comes after the shape step, since no cycle has
/// worn the corrected layer. The last block of a step leaves remeshing to the next step.
Outcome shaped(const Problem& problem, State state, Cache& cache, BlockSpan span, double cycles,
               const Observer& observer) {
  span.jump = levelling * cycles;
  span.remesh = false;
  span.extrapolated = true;
  Outcome outcome = end_block(problem, std::move(state), cache, span, observer);
  const bool levels = span.level || (outcome.remesh_due && !span.last);
  if (!levels || !outcome.failure.empty() || outcome.interrupted) return outcome;
  span.level = span.extrapolated = false;
  outcome = level(problem, std::move(outcome), cache, span, observer);
  if (!outcome.failure.empty() || outcome.interrupted) return outcome;
  span.remesh = !span.last;
  span.moves = true;  // it is shown, or a remesh is due
  return end_block(problem, std::move(outcome.state), cache, span, observer);
}

/// Corrects the halves of an attempt, and the measures of the limits half way, by the wear of both plays.
void extrapolate_trial(const Problem& problem, const solver::System& system, const State& start, bool level,
                       TwicePlayed& attempt, Trial& trial) {
  trial.uncorrected = wear_of(problem, system, attempt.halves);
  const auto by_halves = limit_measures(problem, system, attempt.halves);
  extrapolate(system, {start, attempt.once, attempt.half_way}, attempt.halves);
  trial.corrected = wear_of(problem, system, attempt.halves);
  // The first half has half of the error of both; half of the block with its levelling comes a little later.
  const auto measures = limit_measures(problem, system, attempt.halves);
  for (auto& [name, value] : attempt.middle) {
    value += 0.5 * (measures.at(name) - by_halves.at(name));
    if (level) value += levelling * (measures.at(name) - value);
  }
}

void play_trial(const Problem& problem, const State& start, Cache& cache, const BlockSpan& span,
                const Observer& observer, Trial& trial) {
  BlockSpan block = span;
  block.jump = without_levelling(span);
  block.last = span.last && !span.level;
  TwicePlayed attempt = play_twice(problem, start, cache, block, quiet(observer), trial.rows.observer(observer));
  trial.outcome = {start, attempt.failure, attempt.interrupted};
  trial.outcome.state.counts = attempt.counts;
  if (!attempt.failure.empty() || attempt.interrupted) return;
  // Nothing here holds the system: `shaped` makes the next one, when the factors of the old shapes are released.
  const auto system = [&] { return system_of(problem, attempt.halves, cache); };
  trial.slips_throughout = slips_throughout(start, attempt.halves);
  trial.error = block_error(wear_difference(*system(), {start, attempt.once, attempt.half_way}, attempt.halves),
                            trial.slips_throughout);
  trial.too_long = trial.error > error_allowed(problem, *span.step, start, start.step_cycles + span.jump);
  if (trial.too_long) return;
  extrapolate_trial(problem, *system(), start, span.level, attempt, trial);
  BlockSpan end = span;
  end.moves = attempt.remesh_due;
  trial.outcome =
      shaped(problem, std::move(attempt.halves), cache, std::move(end), block.jump, trial.later.observer(observer));
  trial.outcome.middle = std::move(attempt.middle);
}

/// Reports a trial whose block is kept, and what the next block is to know of it. `state`: at the start of the block.
void accept_trial(const Problem& problem, const State& state, const BlockSpan& span, const Observer& observer,
                  Trial& trial) {
  State& end = trial.outcome.state;
  const double jump = without_levelling(span), before = removed(state), after = removed(end);
  const double share = after > 0.0 ? 1.0 - before / after : 0.0;
  trial.rows.play_back(observer, [&](IncrementRecord& row) {
    correct(row, (row.cycle - state.cycle) / jump, trial.uncorrected, trial.corrected);
  });
  trial.later.play_back(observer);
  const double next = error_allowed(problem, *span.step, state, state.step_cycles + span.jump + span.jump);
  end.jump = next_jump(jump, share, trial.error, next, state.jump_rate);
  end.jump_rate = share > 0.0 ? trial.error / share : 0.0;
  const double kept = (1.0 - share) * (trial.slips_throughout ? 1.0 - share : 1.0);
  end.jump_error = std::max(kept * state.jump_error.value_or(0.0), trial.error);
  tell(observer, span, state.cycle, estimated(trial.error));
}

/// Shortens a block whose trial is not kept.
void refuse_trial(const Problem& problem, const Trial& trial, const Observer& observer, State& start, BlockSpan& span) {
  tell(observer, span, start.cycle, "refused: " + (trial.too_long ? estimated(trial.error) : trial.outcome.failure));
  ++start.counts.refused_blocks;
  const double permitted = error_allowed(problem, *span.step, start, start.step_cycles + span.jump);
  span.jump = std::max(unjumped, shortened(trial.too_long, permitted, trial.error) * span.jump);
  span.last = span.level = false;
}

/// Plays a block of one cycle, without a jump, in place of the one that was tried last.
Outcome play_one_cycle(const Problem& problem, const State& state, Cache& cache, BlockSpan span,
                       const Observer& observer) {
  const double tried = span.jump;
  span.jump = std::min(unjumped, span.jump);
  Outcome outcome = play_block(problem, state, cache, span, observer);
  if (outcome.failure.empty() && !outcome.interrupted) {
    outcome.state.jump = after_one_cycle(tried, state.step_cycles == 0.0);
    outcome.state.jump_rate = 0.0;
    const double after = removed(outcome.state);
    if (state.jump_error && after > 0.0) outcome.state.jump_error = removed(state) / after * *state.jump_error;
  }
  outcome.state.jump = std::max(outcome.state.jump, tried);
  return outcome;
}

}  // namespace

double allowed(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& measure,
               const std::map<std::string, double>& reached, const scene::Step& step, double step_cycles, double end) {
  double growth = step.cycles / end;
  for (const auto& limit : limits) {
    const auto now = measure.find(limit.name);
    if (now == measure.end() || now->second <= 0.0 || reached.contains(limit.name)) continue;
    growth = std::min(growth, bound_of(limit) / now->second * step_cycles / end);
  }
  return step.jump_tolerance * std::clamp(growth, 1.0, most_early);
}

double block_error(double difference, bool slips_throughout) {
  return slips_throughout ? difference : edge_share * difference;
}

double shortened(bool too_long, double allowed, double error) {
  return too_long ? std::clamp(aim * allowed / error, most_cut, 0.7) : most_cut;
}

double after_one_cycle(double tried, bool first) {
  return !first && tried > unjumped ? tried : std::max(most_growth * std::min(unjumped, tried), tried);
}

double next_jump(double jump, double share, double error, double tolerance, double rate_before) {
  const double ratio = error > 0.0 ? aim * tolerance / error : most_growth * most_growth;
  const double steeper =
      rate_before > 0.0 && share > 0.0 ? std::clamp(error / share / rate_before, 1.0, most_steeper) : 1.0;
  const double times = (ratio < 1.0 ? ratio : std::sqrt(ratio)) / steeper;  // factor of the share
  const double factor = share * times < 1.0 ? times / (1.0 - share * times) : most_growth;
  return std::max(unjumped, jump * std::clamp(factor, most_cut, most_growth));
}

Outcome play_controlled(const Problem& problem, const State& state, Cache& cache, BlockSpan span,
                        const Observer& observer) {
  State start = state;
  while (span.jump > unjumped) {
    Trial trial;
    play_trial(problem, start, cache, span, observer, trial);
    keep_counts(start, trial.outcome.state.counts);
    if (trial.outcome.interrupted) return {std::move(start), {}, true};
    if (trial.outcome.failure.empty() && !trial.too_long) {
      accept_trial(problem, state, span, observer, trial);
      return std::move(trial.outcome);
    }
    refuse_trial(problem, trial, observer, start, span);
    if (trial.too_long && (start.step_cycles == 0.0 || span.jump < fewest_tried)) break;
  }
  return play_one_cycle(problem, start, cache, span, observer);
}

}  // namespace reye::sim
