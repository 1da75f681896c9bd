#include "sim/solid/solid_block_play.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "sim/march/jump_rule.hpp"
#include "sim/march/levelling.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/solid/solid_correction.hpp"
#include "sim/solid/solid_limits.hpp"
#include "sim/solid/solid_pressure_change.hpp"

namespace reye::sim {

namespace {

/// A block played twice, to the ends of both plays; none where one failed or was interrupted.
struct Attempt {
  SolidOutcome once, halves;
  std::vector<contact::SkinWear> half_way;
  std::map<std::string, double> middle;
  bool whole = false;  ///< both plays came to their end
  SolidOutcome& ended() { return halves.state.meshes.empty() ? once : halves; }
};

Attempt attempt_twice(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& start, SolidSpan span,
                      const SolidObserver& coarse, const SolidObserver& fine) {
  const auto came_through = [](const SolidOutcome& o) { return o.failure.empty() && !o.interrupted; };
  Attempt attempt;
  attempt.once = player.play(start, span, coarse);
  if (!came_through(attempt.once)) return attempt;
  span.jump *= 0.5;
  SolidRunState again = start;
  keep_work(again, attempt.once.state);
  SolidSpan first = span;
  first.last = false;
  attempt.halves = player.play(std::move(again), first, fine);
  if (!came_through(attempt.halves)) return attempt;
  attempt.half_way = attempt.halves.state.solution.wear;
  attempt.middle = solid_limit_measures(problem, player.system(), attempt.halves.state);
  attempt.halves.state.step_cycles += span.jump;
  attempt.halves = player.play(std::move(attempt.halves.state), span, fine);
  attempt.halves.state.step_cycles -= span.jump;
  attempt.whole = came_through(attempt.halves);
  return attempt;
}

/// The short cycles after a block, and their rows.
struct SolidLevelling {
  SolidPlayer& player;
  const SolidObserver& observer;
  SolidSpan span;
  SolidOutcome outcome;
  bool last = span.last;
  std::vector<Points3> before{};
  SolidRecording rows{};

  bool play(double cycles, bool ends) {
    span.jump = cycles;
    span.last = last && ends;
    before = outcome.state.solution.traction;
    outcome = player.play(std::move(outcome.state), span, rows.observer(observer));
    return outcome.failure.empty() && !outcome.interrupted;
  }
  double change() const {
    double largest = 0.0;
    for (std::size_t c = 0; outcome.state.solved && c < before.size(); ++c)
      largest = std::max(largest, pressure_change(*outcome.state.solved, before[c], c));
    return largest;
  }
  std::pair<SolidOutcome, SolidRecording> kept() const { return {outcome, rows}; }
  bool restore(const std::pair<SolidOutcome, SolidRecording>& start) {
    if (outcome.interrupted) return false;
    const SolidRunState played = std::move(outcome.state);
    std::tie(outcome, rows) = start;
    keep_work(outcome.state, played);
    return true;
  }
};

/// Plays short cycles after a block, without extrapolation: the unevenness that the correction has left is worn level
/// before it is shown.
SolidOutcome level_block(SolidPlayer& player, SolidOutcome outcome, const SolidSpan& span, double cycles,
                         PlayedBefore played_before, const SolidObserver& observer) {
  SolidLevelling run{player, observer, span, std::move(outcome)};
  bool at_once = run.outcome.state.levels_at_once;
  const double left = level(cycles, run.last, played_before, run, at_once);
  run.rows.play_back(observer);
  auto& state = run.outcome.state;
  state.levels_at_once = at_once;
  if (auto warning = uneven(*span.step, state.cycle, left)) {
    const std::string text = in_words(*warning);
    if (warn(state.warnings, std::move(*warning)) && observer.log) observer.log("warning: " + text);
  }
  return std::move(run.outcome);
}

/// Adds to a row of the halves its share of the correction at the end of the block.
void correct_row(SolidIncrement& row, double share, const SolidIncrement& before, const SolidIncrement& after) {
  for (std::size_t c = 0; c < row.contacts.size(); ++c) {
    auto& to = row.contacts[c];
    const auto &from = before.contacts[c], &end = after.contacts[c];
    to.depth_secondary_mm += share * (end.depth_secondary_mm - from.depth_secondary_mm);
    to.depth_primary_mm += share * (end.depth_primary_mm - from.depth_primary_mm);
    to.volume_secondary_mm3 += share * (end.volume_secondary_mm3 - from.volume_secondary_mm3);
    to.volume_primary_mm3 += share * (end.volume_primary_mm3 - from.volume_primary_mm3);
    to.energy_mJ += share * (end.energy_mJ - from.energy_mJ);
  }
}

/// A measure in the middle of a block with the cycles that level it, from that in the middle of its play and at the
/// end.
double middle_with_levelling(double middle, double end) { return middle + levelling * (end - middle); }

/// Levels the end of a trial; its wear is part of what the next block continues.
void level_trial(SolidPlayer& player, const SolidSpan& span, PlayedBefore played_before, const SolidObserver& observer,
                 SolidTrial& trial) {
  const auto before = trial.outcome.state.solution.wear;
  auto middle = std::move(trial.outcome.middle);
  trial.outcome = level_block(player, std::move(trial.outcome), span, levelling * trial.cycles, played_before,
                              trial.later.observer(observer));
  trial.outcome.middle = std::move(middle);
  auto& last = trial.outcome.state.last_wear;
  if (last.cycles == 0.0 || !trial.outcome.failure.empty() || trial.outcome.interrupted) return;
  add_growth(last.contacts, before, trial.outcome.state.solution.wear);
  last.cycles += levelling * trial.cycles;
  last.course = std::move(trial.outcome.worn);
}

}  // namespace

void keep_work(SolidRunState& start, const SolidRunState& played) {
  start.counts = played.counts;
  start.warnings = played.warnings;
  start.cutback_reasons = played.cutback_reasons;
  start.balance = played.balance;
  start.imbalance_N = played.imbalance_N;
  start.largest_force_N = played.largest_force_N;
  start.mortar_s = played.mortar_s;
  start.interface_s = played.interface_s;
  start.factor_s = played.factor_s;
}

void note_wear(const SolidProblem& problem, const SolidRunState& start, double cycles, SolidOutcome& outcome) {
  auto& now = outcome.state;
  now.last_wear = {};
  if (!may_continue(problem.contacts) || now.points != start.points || !slides_throughout(start, now)) return;
  now.last_wear = {cycles, {}, start.limit_measure, std::move(outcome.worn)};
  add_growth(now.last_wear.contacts, start.solution.wear, now.solution.wear);
}

bool play_in_halves(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& begin, const SolidSpan& span,
                    const SolidObserver& observer, double permitted, SolidTrial& trial) {
  SolidSpan block = span;
  block.jump = cycles_of_play(span);
  block.last = span.last && !span.level;
  Attempt attempt = attempt_twice(problem, player, begin, block, quiet(observer), trial.rows.observer(observer));
  if (!attempt.whole) {
    trial.outcome = std::move(attempt.ended());
    return true;
  }
  auto& halves = attempt.halves.state;
  if (halves.points != begin.points) {
    trial.outcome = std::move(attempt.halves);
    return false;
  }
  const SolidTwice twice{begin, attempt.once.state, attempt.half_way};
  trial.cycles = block.jump;
  trial.throughout = slides_throughout(begin, halves);
  trial.error = block_error(skin_wear_difference(player.system(), twice, halves), trial.throughout);
  trial.too_long = trial.error > permitted;
  const auto uncorrected = row_of(problem, player.system(), halves);
  const auto by_halves = solid_limit_measures(problem, player.system(), halves);
  extrapolate_skins(player.system(), twice, halves);
  trial.correct = [=, corrected = row_of(problem, player.system(), halves), from = begin.cycle, cycles = block.jump](
                      SolidIncrement& row) { correct_row(row, (row.cycle - from) / cycles, uncorrected, corrected); };
  // The first half has half of the error of both.
  for (const auto measures = solid_limit_measures(problem, player.system(), halves);
       auto& [name, value] : attempt.middle) {
    value += 0.5 * (measures.at(name) - by_halves.at(name));
    if (span.level) value = middle_with_levelling(value, measures.at(name));
  }
  trial.outcome = std::move(attempt.halves);
  trial.outcome.middle = std::move(attempt.middle);
  note_wear(problem, begin, block.jump, trial.outcome);
  if (!trial.too_long && span.level) level_trial(player, span, PlayedBefore::in_halves, observer, trial);
  return true;
}

double cycles_of_play(const SolidSpan& span) { return span.level ? span.jump / (1.0 + levelling) : span.jump; }

std::optional<SolidRunState> begun(const SolidRunState& start, const TwoStep& formula) {
  std::optional<SolidRunState> state = start;
  if (!add_share(state->solution.wear, start.last_wear.contacts, formula.start())) return std::nullopt;
  return state;
}

bool play_continued(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& start, SolidRunState begun,
                    const TwoStep& formula, SolidSpan span, const SolidObserver& observer, double permitted,
                    SolidTrial& trial) {
  const SolidSpan whole = span;
  const double cycles = cycles_of_play(span);
  span.last = span.last && !span.level;
  const auto at_start = row_of(problem, player.system(), start), at_beginning = row_of(problem, player.system(), begun);
  const auto from = begun.solution.wear;
  span.jump = formula.played() * cycles;
  span.continued = Continued{start.cycle + cycles, &start.last_wear.course};
  trial.outcome = player.play(std::move(begun), span, trial.rows.observer(observer));
  auto& end = trial.outcome.state;
  if (!trial.outcome.failure.empty() || trial.outcome.interrupted) return true;
  if (end.points != start.points) return false;
  end.cycle = start.cycle + cycles;
  keep_still(start.solution.wear, from, end.solution.wear);
  trial.cycles = cycles;
  trial.throughout = slides_throughout(start, end);
  const auto difference = continued_skin_difference(player.system(), start, formula, end);
  trial.serves = difference && trial.throughout;
  if (!trial.serves) return true;
  trial.error = block_error(*difference, trial.throughout);
  trial.too_long = trial.error > permitted;
  trial.correct = [=, first = start.cycle, played = formula.played()](SolidIncrement& row) {
    row.cycle = first + (row.cycle - first) / played;
    correct_row(row, 1.0 - (row.cycle - first) / cycles, at_beginning, at_start);
  };
  const auto measures = solid_limit_measures(problem, player.system(), end);
  trial.outcome.middle = half_way(start.last_wear, start.limit_measure, measures, cycles);
  if (whole.level)
    for (auto& [name, value] : trial.outcome.middle) value = middle_with_levelling(value, measures.at(name));
  note_wear(problem, start, cycles, trial.outcome);
  if (whole.level && !trial.too_long) level_trial(player, whole, PlayedBefore::continued, observer, trial);
  return true;
}

}  // namespace reye::sim
