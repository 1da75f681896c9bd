#include "sim/jump.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

#include "sim/measure.hpp"
#include "sim/timer.hpp"

namespace reye::sim {

namespace {

constexpr double fewest = 1.0;   ///< cycles of a block that is never refused for its error
constexpr double left = 0.8;     ///< of a block's difference after extrapolation (results/cycle_jump)
constexpr double aim = 0.9;      ///< times the tolerance, for the next block
constexpr double refusal = 4.0;  ///< times the tolerance: a block's error fades as more is worn, repeating costs three cycles
constexpr double most_growth = 4.0, most_cut = 0.3;  ///< of the cycles from one block to the next

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

double side_difference(const mortar::Surface& surface, const std::vector<double>& once, const std::vector<double>& halves) {
  const double volume = sum(halves), depth = deepest(surface, halves);
  if (volume <= 0.0) return 0.0;
  double apart = 0.0;
  for (std::size_t j = 0; j < halves.size(); ++j) apart += std::abs(halves[j] - once[j]);
  return std::max(apart / volume, std::abs(depth - deepest(surface, once)) / depth);
}

double removed(const State& state) {
  double volume = 0.0;
  for (const auto& c : state.solution.contacts) volume += sum(c.removed_secondary) + sum(c.removed_primary);
  return volume;
}

/// What the halves have corrected per node, such that no waiting volume becomes negative and the sum stays; empty when
/// that cannot be.
std::vector<double> correction(const std::vector<double>& once, const std::vector<double>& halves,
                               const std::vector<double>& pending) {
  std::vector<double> d(halves.size());
  double cut = 0.0, gained = 0.0;
  for (std::size_t j = 0; j < d.size(); ++j) {
    const double wanted = halves[j] - once[j];
    d[j] = std::max(wanted, -pending[j]);
    cut += d[j] - wanted;
    gained += std::max(d[j], 0.0);
  }
  if (cut > gained) return {};
  if (cut > 0.0)
    for (double& v : d)
      if (v > 0.0) v *= 1.0 - cut / gained;
  return d;
}

void add(std::vector<double>& to, const std::vector<double>& d) {
  for (std::size_t j = 0; j < d.size(); ++j) to[j] += d[j];
}

/// x + (x - once), not below zero.
void double_correction(double once, double& x) { x = std::max(0.0, 2.0 * x - once); }

/// Hears of progress and cut-backs, and may interrupt: what a block that may be refused tells at once.
Observer quiet(const Observer& outside) {
  Observer o;
  o.progress = outside.progress;
  o.interrupted = outside.interrupted;
  o.log = outside.log;
  return o;
}

/// What happens in a block that may be refused: told when it is not.
struct Recording {
  std::vector<std::function<void(const Observer&)>> events;

  Observer observer(const Observer& outside) {
    Observer o = quiet(outside);
    if (outside.increment)
      o.increment = [this](const IncrementRecord& r) { events.push_back([r](const Observer& to) { to.increment(r); }); };
    if (outside.frame) o.frame = [this](const Frame& f) { events.push_back([f](const Observer& to) { to.frame(f); }); };
    return o;
  }
};

/// Both ends of a block, before its shape step.
struct Attempt {
  State once, halves;
  std::map<std::string, double> middle;  ///< measures of the limits after the first half
  std::string failure;
  bool interrupted = false;
  Counts counts;
};

Attempt try_block(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& coarse,
                  const Observer& fine) {
  Attempt attempt;
  attempt.counts = state.counts;
  span.remesh = false;  // nodes must be the same at both ends
  const auto over = [&](const Outcome& outcome) {
    attempt.counts = outcome.state.counts;
    attempt.failure = outcome.failure;
    attempt.interrupted = outcome.interrupted;
    return !outcome.failure.empty() || outcome.interrupted;
  };
  Outcome outcome = play_increments(problem, state, cache, span, coarse);
  if (over(outcome)) return attempt;
  attempt.once = std::move(outcome.state);
  span.jump *= 0.5;
  State start = state;
  start.counts = attempt.counts;
  start.recall = attempt.once.recall;
  BlockSpan first = span;
  first.last = false;
  outcome = play_increments(problem, std::move(start), cache, first, fine);
  if (over(outcome)) return attempt;
  if (problem.scene.shape) {
    outcome = evolve_shape(problem, std::move(outcome.state), cache, span, {});
    if (over(outcome)) return attempt;
  }
  attempt.middle = limit_measures(problem, system_of(problem, outcome.state, cache), outcome.state);
  outcome.state.step_cycles += span.jump;
  outcome = play_increments(problem, std::move(outcome.state), cache, span, fine);
  outcome.state.step_cycles -= span.jump;
  if (over(outcome)) return attempt;
  attempt.halves = std::move(outcome.state);
  return attempt;
}

void tell(const Observer& observer, const BlockSpan& span, double cycle, const std::string& what) {
  if (!observer.log) return;
  char text[120];
  std::snprintf(text, sizeof text, ", cycle %g, block of %g cycles: ", cycle, span.jump);
  observer.log("step \"" + span.step->name + '"' + text + what);
}

std::string estimated(double error) {
  char text[80];
  std::snprintf(text, sizeof text, "estimated error %.3g %%", 100.0 * error);
  return text;
}

}  // namespace

double wear_difference(const solver::System& system, const State& once, const State& halves) {
  double difference = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto &a = once.solution.contacts[c], &b = halves.solution.contacts[c];
    difference = std::max({difference, side_difference(setup.secondary, a.removed_secondary, b.removed_secondary),
                           side_difference(setup.primary, a.removed_primary, b.removed_primary)});
  }
  return difference;
}

void extrapolate(const State& once, State& halves) {
  for (std::size_t c = 0; c < halves.solution.contacts.size(); ++c) {
    const auto& a = once.solution.contacts[c];
    auto& b = halves.solution.contacts[c];
    const auto secondary = correction(a.removed_secondary, b.removed_secondary, b.pending_secondary);
    const auto primary = correction(a.removed_primary, b.removed_primary, b.pending_primary);
    if (secondary.size() != b.removed_secondary.size() || primary.size() != b.removed_primary.size()) continue;
    add(b.removed_secondary, secondary);
    add(b.pending_secondary, secondary);
    add(b.removed_primary, primary);
    add(b.pending_primary, primary);
    for (std::size_t j = 0; j < b.slip.size(); ++j) double_correction(a.slip[j], b.slip[j]);
    for (std::size_t j = 0; j < b.energy_secondary.size(); ++j) double_correction(a.energy_secondary[j], b.energy_secondary[j]);
    double_correction(a.frictional_work, b.frictional_work);
    double_correction(a.worn_work, b.worn_work);
    double_correction(a.law_work, b.law_work);
  }
}

double next_jump(double jump, double error, double tolerance, double growth) {
  const double factor = error > 0.0 ? growth * std::sqrt(aim * tolerance / error) : most_growth;
  return std::max(fewest, jump * std::clamp(factor, most_cut, most_growth));
}

Outcome play_controlled(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& observer) {
  const double tolerance = span.step->jump_tolerance;
  State start = state;
  for (;;) {
    Recording recording;
    Attempt attempt = try_block(problem, start, cache, span, quiet(observer), recording.observer(observer));
    start.counts = attempt.counts;
    if (attempt.interrupted) return {std::move(start), {}, true};
    const bool played = attempt.failure.empty(), least = span.jump <= fewest;
    const double error =
        played ? left * wear_difference(system_of(problem, attempt.halves, cache), attempt.once, attempt.halves) : 0.0;
    const bool too_long = error > refusal * tolerance && !least;
    std::string why = too_long ? estimated(error) : attempt.failure;
    if (why.empty()) {
      extrapolate(attempt.once, attempt.halves);
      Outcome outcome = end_block(problem, std::move(attempt.halves), cache, span, observer);
      if (outcome.failure.empty()) {
        for (const auto& event : recording.events) event(observer);
        const double before = removed(state), after = removed(outcome.state);
        outcome.state.jump = next_jump(span.jump, error, tolerance, before > 0.0 ? after / before : most_growth);
        outcome.state.jump_error = std::max(after > 0.0 ? before / after * state.jump_error.value_or(0.0) : 0.0, error);
        outcome.middle = std::move(attempt.middle);
        tell(observer, span, state.cycle, estimated(error));
        return outcome;
      }
      why = outcome.failure;
    }
    if (least) return {std::move(start), why, false};
    tell(observer, span, start.cycle, "refused: " + why);
    ++start.counts.refused_blocks;
    span.jump = too_long ? next_jump(span.jump, error, tolerance, 1.0) : std::max(fewest, most_cut * span.jump);
    span.last = false;
  }
}

}  // namespace reye::sim
