#include "sim/solid/solid_jump.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/solid/solid_block_play.hpp"

namespace reye::sim {

namespace {

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

/// Whether a trial has been played to its end by the two-step formula, or ends otherwise. Where some of a contact has
/// come to stick only what it cost is kept.
bool continue_block(const SolidProblem& problem, SolidPlayer& player, SolidRunState& begin, const SolidSpan& span,
                    const SolidObserver& observer, double permitted, SolidTrial& trial) {
  if (problem.scene.frames.every_increment) return false;
  const auto formula = two_step(cycles_of_play(span), begin.last_wear.cycles);
  auto state = formula ? begun(begin, *formula) : std::nullopt;
  if (!state) return false;
  const bool same_points =
      play_continued(problem, player, begin, std::move(*state), *formula, span, observer, permitted, trial);
  const auto& outcome = trial.outcome;
  if (!outcome.failure.empty() || outcome.interrupted || (same_points && trial.serves)) return true;
  keep_work(begin, outcome.state);
  begin = player.brought_up(std::move(begin));
  trial = {};
  return false;
}

void play_solid_trial(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& start,
                      const SolidSpan& span, const SolidObserver& observer, SolidTrial& trial) {
  const double permitted = allowed_error(problem, *span.step, start, start.step_cycles + span.jump);
  SolidRunState begin = player.brought_up(start);
  if (continue_block(problem, player, begin, span, observer, permitted, trial)) return;
  if (play_in_halves(problem, player, begin, span, observer, permitted, trial)) return;
  SolidRunState again = player.brought_up(start);  // contact has outrun its points
  keep_work(again, trial.outcome.state);
  trial = {};
  play_solid_trial(problem, player, again, span, observer, trial);
}

void accept_solid_trial(const SolidProblem& problem, const SolidRunState& state, const SolidSpan& span,
                        const SolidObserver& observer, SolidTrial& trial) {
  SolidRunState& end = trial.outcome.state;
  const double before = removed_volume(state), after = removed_volume(end);
  const double share = after > 0.0 ? 1.0 - before / after : 0.0;
  trial.rows.play_back(observer, trial.correct);
  trial.later.play_back(observer);
  const double next = allowed_error(problem, *span.step, state, state.step_cycles + 2.0 * span.jump);
  end.jump = next_jump(trial.cycles, share, trial.error, next, state.jump_rate);
  end.jump_rate = share > 0.0 ? trial.error / share : 0.0;
  const double kept = (1.0 - share) * (trial.throughout ? 1.0 - share : 1.0);
  end.jump_error = std::max(kept * state.jump_error.value_or(0.0), trial.error);
  if (end.last_wear.cycles > 0.0) end.jump = to_continue(end.jump, end.last_wear.cycles, *end.jump_error / next);
  tell_block(observer, span, state.cycle, base::formatted("estimated error %.3g %%", 100.0 * trial.error));
}

SolidOutcome play_one_solid_cycle(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& state,
                                  SolidSpan span, const SolidObserver& observer) {
  const double tried = span.jump;
  span.jump = std::min(unjumped, span.jump);
  SolidOutcome outcome = player.play(state, span, observer);
  if (outcome.failure.empty() && !outcome.interrupted) {
    const bool first = state.step_cycles == 0.0;
    note_wear(problem, state, span.jump, outcome);
    const bool continues = outcome.state.last_wear.cycles > 0.0;
    if (first) outcome.state.last_wear = {};
    outcome.state.jump = after_one_cycle(tried, first, continues);
    outcome.state.jump_rate = 0.0;
    const double after = removed_volume(outcome.state);
    if (state.jump_error && after > 0.0) outcome.state.jump_error = removed_volume(state) / after * *state.jump_error;
  }
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
    const bool too_few = span.jump < fewest_tried && start.last_wear.cycles == 0.0;
    if (trial.too_long && (start.step_cycles == 0.0 || too_few)) break;
  }
  SolidObserver without_states = observer;  // none of them is at the end of a block
  without_states.state = {};
  SolidOutcome outcome = play_one_solid_cycle(problem, player, start, span, without_states);
  if (outcome.interrupted) outcome.state = std::move(start);
  return outcome;
}

}  // namespace reye::sim
