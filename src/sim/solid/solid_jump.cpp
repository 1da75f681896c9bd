#include "sim/solid/solid_jump.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/formatted.hpp"
#include "sim/march/jump.hpp"
#include "sim/solid/solid_correction.hpp"
#include "sim/solid/solid_limits.hpp"
#include "sim/solid/solid_recording.hpp"

namespace reye::sim {

namespace {

/// Counts of the work done continue where the state itself begins again.
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

void tell_block(const SolidObserver& observer, const SolidSpan& span, double cycle, const std::string& what) {
  if (observer.log)
    observer.log(
        base::formatted("step \"%s\", cycle %g, block of %g cycles: ", span.step->name.c_str(), cycle, span.jump) +
        what);
}

/// Of the tolerance, for errors of blocks of one sign add up where pressures fade as bodies wear apart.
constexpr double caution = 0.5;

/// The error that a block from `start` to `end` of its step may have.
double allowed_error(const SolidProblem& problem, const scene::Step& step, const SolidRunState& start, double end) {
  return caution * allowed(problem.scene.limits, start.limit_measure, start.life_cycles, step, start.step_cycles, end);
}

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

/// Plays short cycles after a block, without extrapolation, half of the cycles that are left in each: the unevenness
/// that the correction has left is worn level before it is shown.
SolidOutcome level_block(SolidPlayer& player, SolidOutcome outcome, SolidSpan span, double cycles,
                         const SolidObserver& observer) {
  constexpr int levelling_cycles = 3;
  const bool last = span.last;
  double left = cycles;
  for (int k = 0; k < levelling_cycles; ++k) {
    if (k + 1 < levelling_cycles) left *= 0.5;
    span.jump = left;
    span.last = last && k + 1 == levelling_cycles;
    outcome = player.play(std::move(outcome.state), span, observer);
    if (!outcome.failure.empty() || outcome.interrupted) break;
  }
  return outcome;
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

/// One try of a block.
struct SolidTrial {
  SolidOutcome outcome;
  double error = 0.0;
  bool too_long = false, throughout = false;
  SolidRecording rows, later;
  SolidIncrement uncorrected, corrected;
};

double block_without_levelling(const SolidSpan& span) { return span.level ? span.jump / (1.0 + levelling) : span.jump; }

void play_solid_trial(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& start,
                      const SolidSpan& span, const SolidObserver& observer, SolidTrial& trial) {
  SolidSpan block = span;
  block.jump = block_without_levelling(span);
  block.last = span.last && !span.level;
  const SolidRunState begin = player.brought_up(start);
  Attempt attempt = attempt_twice(problem, player, begin, block, quiet(observer), trial.rows.observer(observer));
  if (!attempt.whole) {
    trial.outcome = std::move(attempt.ended());
    return;
  }
  auto& halves = attempt.halves.state;
  if (halves.points != begin.points) {  // contact outran its nodes: the trial begins again with more of them
    SolidRunState again = player.brought_up(start);
    keep_work(again, halves);
    trial = {};
    return play_solid_trial(problem, player, again, span, observer, trial);
  }
  const SolidTwice twice{begin, attempt.once.state, attempt.half_way};
  trial.throughout = slides_throughout(begin, halves);
  trial.error = block_error(skin_wear_difference(player.system(), twice, halves), trial.throughout);
  trial.too_long = trial.error > allowed_error(problem, *span.step, start, start.step_cycles + span.jump);
  trial.uncorrected = row_of(problem, player.system(), halves);
  const auto by_halves = solid_limit_measures(problem, player.system(), halves);
  extrapolate_skins(player.system(), twice, halves);
  trial.corrected = row_of(problem, player.system(), halves);
  // The first half has half of the error of both; half of the block with its levelling comes a little later.
  for (const auto measures = solid_limit_measures(problem, player.system(), halves);
       auto& [name, value] : attempt.middle) {
    value += 0.5 * (measures.at(name) - by_halves.at(name));
    if (span.level) value += levelling * (measures.at(name) - value);
  }
  trial.outcome = std::move(attempt.halves);
  if (!trial.too_long && span.level)
    trial.outcome =
        level_block(player, std::move(trial.outcome), span, levelling * block.jump, trial.later.observer(observer));
  trial.outcome.middle = std::move(attempt.middle);
}

void accept_solid_trial(const SolidProblem& problem, const SolidRunState& state, const SolidSpan& span,
                        const SolidObserver& observer, SolidTrial& trial) {
  SolidRunState& end = trial.outcome.state;
  const double jump = block_without_levelling(span), before = removed_volume(state), after = removed_volume(end);
  const double share = after > 0.0 ? 1.0 - before / after : 0.0;
  trial.rows.play_back(observer, [&](SolidIncrement& row) {
    correct_row(row, (row.cycle - state.cycle) / jump, trial.uncorrected, trial.corrected);
  });
  trial.later.play_back(observer);
  const double next = allowed_error(problem, *span.step, state, state.step_cycles + 2.0 * span.jump);
  end.jump = next_jump(jump, share, trial.error, next, state.jump_rate);
  end.jump_rate = share > 0.0 ? trial.error / share : 0.0;
  const double kept = (1.0 - share) * (trial.throughout ? 1.0 - share : 1.0);
  end.jump_error = std::max(kept * state.jump_error.value_or(0.0), trial.error);
  tell_block(observer, span, state.cycle, base::formatted("estimated error %.3g %%", 100.0 * trial.error));
}

SolidOutcome play_one_solid_cycle(SolidPlayer& player, const SolidRunState& state, SolidSpan span,
                                  const SolidObserver& observer) {
  const double tried = span.jump;
  span.jump = std::min(unjumped, span.jump);
  SolidOutcome outcome = player.play(state, span, observer);
  if (outcome.failure.empty() && !outcome.interrupted) {
    outcome.state.jump = after_one_cycle(tried, state.step_cycles == 0.0);
    outcome.state.jump_rate = 0.0;
    const double after = removed_volume(outcome.state);
    if (state.jump_error && after > 0.0) outcome.state.jump_error = removed_volume(state) / after * *state.jump_error;
  }
  outcome.state.jump = std::max(outcome.state.jump, tried);
  return outcome;
}

}  // namespace

SolidOutcome play_fixed_block(SolidPlayer& player, const SolidRunState& state, SolidSpan span,
                              const SolidObserver& observer) {
  if (!span.cycles || !span.step->wear || span.jump <= 1.0) return player.play(state, span, observer);
  constexpr double shorter = 0.25;
  const double wanted = span.jump;
  SolidRunState start = state;
  for (;;) {
    SolidRecording recording;
    SolidOutcome outcome = player.play(start, span, recording.observer(observer));
    if (outcome.failure.empty() || span.jump <= 1.0) {
      if (outcome.interrupted) outcome.state = start;
      recording.play_back(observer);
      if (span.jump < wanted && outcome.failure.empty() && !outcome.interrupted) {
        outcome.state.block_cycles = span.jump;
        outcome.state.warnings.push_back(
            {"jump", "step " + span.step->name,
             base::formatted("A block of %g cycles failed at cycle %g; from there on blocks have %g. "
                             "Write jump = %g, or jump = { tolerance = 0.01 }.",
                             wanted, state.cycle, span.jump, span.jump),
             wanted / span.jump});
      }
      return outcome;
    }
    tell_block(observer, span, state.cycle, "shortened: " + outcome.failure);
    keep_work(start, outcome.state);
    ++start.counts.refused_blocks;
    span.jump = std::max(1.0, std::floor(shorter * span.jump));
    span.last = false;
  }
}

SolidOutcome play_controlled_block(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& state,
                                   SolidSpan span, const SolidObserver& observer) {
  SolidRunState start = state;
  while (span.jump > unjumped) {
    SolidTrial trial;
    play_solid_trial(problem, player, start, span, observer, trial);
    keep_work(start, trial.outcome.state);
    if (trial.outcome.interrupted) {
      trial.outcome.state = std::move(start);
      return std::move(trial.outcome);
    }
    const bool came_through = trial.outcome.failure.empty();
    if (came_through && !trial.too_long) {
      accept_solid_trial(problem, state, span, observer, trial);
      return std::move(trial.outcome);
    }
    tell_block(observer, span, start.cycle,
               "refused: " + (came_through ? base::formatted("estimated error %.3g %%", 100.0 * trial.error)
                                           : trial.outcome.failure));
    ++start.counts.refused_blocks;
    const double permitted = allowed_error(problem, *span.step, start, start.step_cycles + span.jump);
    span.jump = std::max(unjumped, shortened(trial.too_long, permitted, trial.error) * span.jump);
    span.last = span.level = false;
    if (trial.too_long && (start.step_cycles == 0.0 || span.jump < fewest_tried)) break;
  }
  SolidObserver without_states = observer;  // none of them is at the end of a block
  without_states.state = {};
  SolidOutcome outcome = play_one_solid_cycle(player, start, span, without_states);
  if (outcome.interrupted) outcome.state = std::move(start);
  return outcome;
}

}  // namespace reye::sim
