#include "sim/march/level.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "sim/march/block.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/march/levelling.hpp"
#include "sim/march/recording.hpp"
#include "sim/problem/two_step.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/reshape/balance.hpp"

namespace reye::sim {

namespace {

/// Difference of the pressures of a state from those held before it, of the worst contact, in the mean
/// (`pressure_jump`). A contact that has worn and carries nothing at the ends of its cycles says nothing of the
/// pressures inside them: at the end of a step (`last`) the change is then unbounded, on the way where no other contact
/// carries.
double pressure_change(const Problem& problem, const State& state, Cache& cache,
                       const std::vector<HeldTraction>& before, bool last) {
  const auto kept = system_of(problem, state, cache);
  const auto& system = *kept;
  double largest = 0.0;
  bool unknown = false, carries = false;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& contact = state.solution.contacts[c];
    const auto& pressed = before[c].normal;
    const bool open = std::none_of(pressed.begin(), pressed.end(), [](double force) { return force > 0.0; });
    unknown |= open && contact.law_volume > 0.0;
    carries |= !open;
    largest = std::max(largest, pressure_jump(system.contacts[c], contact, before[c]));
  }
  return unknown && (last || !carries) ? std::numeric_limits<double>::infinity() : largest;
}

/// The short cycles after a block, and their rows.
struct PlaneLevelling {
  const Problem& problem;
  Cache& cache;
  const Observer& observer;
  BlockSpan span;
  Outcome outcome;
  bool last = span.last;
  std::vector<HeldTraction> before{};
  Recording rows{};

  bool play(double cycles, bool ends) {
    span.jump = cycles;
    span.last = last && ends;
    before = held_tractions(*system_of(problem, outcome.state, cache), outcome.state);
    outcome = play_increments(problem, std::move(outcome.state), cache, span, rows.observer(observer));
    return outcome.failure.empty() && !outcome.interrupted;
  }
  double change() const { return pressure_change(problem, outcome.state, cache, before, last); }
  std::pair<Outcome, Recording> kept() const { return {outcome, rows}; }
  bool restore(const std::pair<Outcome, Recording>& start) {
    if (outcome.interrupted) return false;
    const Counts played = outcome.state.counts;
    std::tie(outcome, rows) = start;
    keep_counts(outcome.state, played);
    return true;
  }
};

/// Plays short cycles after a block, without extrapolation: unevenness left by the correction or a fresh mesh is worn
/// level before it is shown or jumped from. Their wear waits in the gap. The first remove the unevenness, the last wear
/// so little that pressures follow the stroke. Where they are `shown` and do not repeat it warns.
Outcome level_end(const Problem& problem, Outcome outcome, Cache& cache, BlockSpan span, bool shown,
                  const Observer& observer) {
  const auto played_before = span.extrapolated ? PlayedBefore::in_halves : PlayedBefore::continued;
  span.level = span.extrapolated = false;
  PlaneLevelling run{problem, cache, observer, std::move(span), std::move(outcome)};
  bool at_once = run.outcome.state.levels_at_once;
  const double left = level(run.span.jump, run.last, played_before, run, at_once);
  run.outcome.state.levels_at_once = at_once;
  run.rows.play_back(observer);
  if (auto warning = uneven(*run.span.step, run.outcome.state.cycle, left); warning && shown)
    warn(run.outcome.state, observer, std::move(*warning));
  return std::move(run.outcome);
}

}  // namespace

Outcome shaped(const Problem& problem, State state, Cache& cache, BlockSpan span, double cycles,
               const Observer& observer) {
  if (!span.extrapolated && !span.level) {
    span.jump = cycles;
    return end_block(problem, std::move(state), cache, span, observer);
  }
  span.jump = levelling * cycles;
  span.remesh = false;
  Outcome outcome{std::move(state), {}, false};
  if (span.extrapolated)  // else all wear waits in the gap, as it did in the play
    outcome = end_block(problem, std::move(outcome.state), cache, span, observer);
  const bool levels = span.level || (outcome.remesh_due && !span.last);
  if (!levels || !outcome.failure.empty() || outcome.interrupted) return outcome;
  const bool shown = span.level;
  const auto before = outcome.state.solution.contacts;
  outcome = level_end(problem, std::move(outcome), cache, span, shown, observer);
  if (!outcome.failure.empty() || outcome.interrupted) return outcome;
  if (auto& worn = outcome.state.last_wear; worn.cycles > 0.0) {
    add_growth(worn.contacts, before, outcome.state.solution.contacts);
    worn.cycles += levelling * cycles;
    worn.course = std::move(outcome.worn);
  }
  span.level = span.extrapolated = false;
  span.remesh = !span.last;
  span.moves = true;  // it is shown, or a remesh is due
  return end_block(problem, std::move(outcome.state), cache, span, observer);
}

}  // namespace reye::sim
