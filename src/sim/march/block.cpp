#include "sim/march/block.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/formatted.hpp"
#include "sim/march/watch_contacts.hpp"
#include "sim/measure/bond_traction.hpp"
#include "sim/measure/figures.hpp"
#include "sim/measure/frame.hpp"
#include "sim/measure/nodal_depth.hpp"
#include "sim/measure/seen_in_gaps.hpp"
#include "sim/measure/why_failed.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/problem/timer.hpp"
#include "sim/reshape/approach.hpp"
#include "sim/reshape/depth.hpp"
#include "sim/reshape/equilibrate.hpp"
#include "sim/reshape/renew.hpp"
#include "sim/reshape/shape.hpp"

namespace reye::sim {

namespace {

IncrementRecord record_of(const Problem& problem, const State& state, const solver::System& system,
                          const solver::Controls& controls, const BlockSpan& span, double progress, int newton) {
  IncrementRecord r = figures_of(problem, state, system, controls);
  r.step = span.step->name;
  r.cycle = cycle_at(span, state.cycle, progress);
  r.progress = progress;
  r.newton = newton;
  return r;
}

/// True where a history that the step plays has a corner: the motion does not continue as before.
bool corner_at(const scene::Scene& scene, const scene::Step& step, double progress) {
  for (const auto& name : step.play)
    for (const auto& corner : scene.histories.at(name))
      if (std::abs(corner[0] - progress) < 1e-9) return true;
  return false;
}

/// The block being played: its start, whether its increments are rows of the history, the length of its last increment
/// (0: none to continue from) and its cost.
struct Playing {
  const BlockSpan& span;
  const Observer& observer;
  std::map<std::string, double> held;
  bool in_history = true;
  double last_length = 0.0;
  int newton = 0;
  std::vector<double> ends{};  ///< of the increments played so far
  Volumes at_start{};          ///< volumes removed; empty: the course is not noted
  CourseOfWear worn{};
};

/// The addition to the message of an increment that fails while a drawn overlap is let in.
std::string in_words_of_overlap(const std::map<std::string, double>& factors) {
  const auto left = factors.find(overlap_left);
  if (left == factors.end() || left->second == 1.0) return {};
  return base::formatted(", %.3g %% of the drawn overlap let in", 100.0 * (1.0 - left->second));
}

void note_cutback(State& state, const std::string& where, const Observer& observer) {
  if (++state.counts.cutbacks <= told_cutbacks) state.cutback_reasons.push_back(where);
  if (observer.log) observer.log("cut back: " + where);
}

/// What is prescribed, loaded and asked of the contacts in the increment from progress `from` to `to`.
solver::Controls asked(const Problem& problem, const State& state, const solver::System& system, const Playing& block,
                       const std::map<std::string, double>& factors, double from, double to) {
  const auto& span = block.span;
  auto controls = controls_at(problem, system, factors, *span.step, from, to, to > from ? span.jump : 1.0);
  set_cycle(controls, problem, span.continued ? span.continued->cycle : state.cycle);
  set_seen_in_gaps(controls, problem, state, system, span, to);
  count_from_renewal(controls, problem, system, state);
  const double last = block.last_length;
  if (last > 0.0 && !corner_at(problem.scene, *span.step, from)) controls.continues = (to - from) / last;
  if (span.cycles) controls.guess = recalled(state.recall, state.step, from, to);
  if (span.cycles && from == 0.0) controls.ahead = touched(state.recall, state.step);
  return controls;
}

/// Notes what the play has worn until progress `to`; no more where a body has got other nodes.
void note_course(Playing& block, const State& state, double to) {
  const auto removed = removed_volumes(state.solution.contacts);
  if (same_sizes(removed, block.at_start))
    block.worn.note(to, removed, block.at_start);
  else
    block.at_start.clear();
}

/// The state that an increment has led to, with what is seen and recorded of it.
void accept(const Problem& problem, State& state, const solver::System& system, Playing& block,
            const solver::Controls& controls, const std::map<std::string, double>& factors, double from, double to,
            solver::SolveResult result) {
  const auto& span = block.span;
  if (span.cycles) note(state.recall, state.step, from, to, state.solution, result.state);
  state.solution = std::move(result.state);
  state.factors = factors;
  block.last_length = to - from;
  if (to > from) block.ends.push_back(to);
  if (to > from && !block.at_start.empty()) note_course(block, state, to);
  block.newton = result.report.solves;
  watch_contacts(problem, state, system, span.step->wear);
  watch_bonds(state, bond_tractions(problem, state, system, cycle_at(span, state.cycle, to)));
  state.shown = false;
  ++state.counts.increments;
  if (block.observer.increment && block.in_history)
    block.observer.increment(record_of(problem, state, system, controls, span, to, result.report.solves));
}

/// Where an increment has failed.
std::string place_of(const State& state, const BlockSpan& span, const std::map<std::string, double>& factors,
                     double from, double to) {
  const std::string progress = base::formatted("\", cycle %.9g, progress %.4g to %.4g", state.cycle, from, to);
  return "step \"" + span.step->name + progress + in_words_of_overlap(factors) + ": ";
}

/// One increment from progress `from` to `to`; on failure it is halved, up to `depth` times.
std::string play(const Problem& problem, State& state, Cache& cache, Playing& block, double from, double to,
                 int depth) {
  const auto& span = block.span;
  const auto kept = timed_system(problem, state, cache);
  const auto& system = *kept;
  const auto factors = factors_at(problem.scene.histories, *span.step, to, block.held);
  const auto controls = asked(problem, state, system, block, factors, from, to);
  solver::SolveResult result;
  {
    Timer timer(cache, "solver");
    result = cache.newton.solve(system, state.solution, controls);
  }
  state.counts.newton_iterations += result.report.solves;
  if (!result.report.converged) {
    const std::string where = place_of(state, span, factors, from, to);
    if (depth == 0) {
      if (block.observer.log) block.observer.log("no state: " + where + result.report.reason);
      const Attempt attempt{span.step, span.jump, result.report.failure, result.report.reason};
      return scene_line(problem.scene, "step " + span.step->name) + where + why_failed(problem, state, attempt, system);
    }
    note_cutback(state, where + result.report.reason, block.observer);
    const double middle = 0.5 * (from + to);
    block.last_length = 0.0;
    const std::string first = play(problem, state, cache, block, from, middle, depth - 1);
    return first.empty() ? play(problem, state, cache, block, middle, to, depth - 1) : first;
  }
  {
    Timer timer(cache, "sim");
    accept(problem, state, system, block, controls, factors, from, to, std::move(result));
  }
  if (span.remesh && renew_references(problem, state, cache, span, block.observer)) block.last_length = 0.0;
  return {};
}

double deepest_of_all(const Problem& problem, const solver::System& system, const State& state) {
  double depth = 0.0;
  const auto removed = removed_as_shown(problem, state);
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    depth = std::max({depth, deepest(system.contacts[c].secondary, removed[c][0]),
                      deepest(system.contacts[c].primary, removed[c][1])});
  return depth;
}

void tell_progress(const Playing& block, const Problem& problem, const State& state, const solver::System& system,
                   int increment, int increments, double progress) {
  if (!block.observer.progress) return;
  const BlockSpan& span = block.span;
  Progress p;
  p.step = span.step->name;
  p.cycle = cycle_at(span, state.cycle, progress);
  p.cycles = span.step->cycles;
  p.increment = increment;
  p.increments = increments;
  p.newton = block.newton;
  p.depth_max_mm = deepest_of_all(problem, system, state);
  p.fraction = span.cycles ? (state.step_cycles + span.jump * progress) / span.step->cycles : progress;
  p.solved = static_cast<double>(state.counts.increments);
  p.to_be_solved = std::max(0.0, span.increments_of_run - p.solved);
  block.observer.progress(p);
}

/// The increments of a continued play see all that it is expected to wear, from its start on: bodies settle into that
/// wear in one motion. No cycle makes it, but the first increment would, and its slip would count in all cycles of the
/// play: under a force on an inclined face as much as the strokes themselves. `from`, `to`: progress from which on the
/// wear is seen, before and after; in parts where Newton does not find the whole of it, halved up to `depth` times.
std::string settle_ahead(const Problem& problem, State& state, Cache& cache, const BlockSpan& span, double from,
                         double to, int depth) {
  const auto held = held_tractions(*system_of(problem, state, cache), state);
  std::string failure = re_equilibrate(problem, state, cache, span, held, to);
  if (failure.empty() || depth == 0) return failure;
  ++state.counts.cutbacks;
  const double middle = 0.5 * (from + to);
  failure = settle_ahead(problem, state, cache, span, from, middle, depth - 1);
  return failure.empty() ? settle_ahead(problem, state, cache, span, middle, to, depth - 1) : failure;
}

}  // namespace

void keep_counts(State& start, const Counts& played) {
  const long remeshes = start.counts.remeshes;
  start.counts = played;
  start.counts.remeshes = remeshes;
}

void begin_state(const Problem& problem, State& state, Cache& cache) {
  const auto kept = timed_system(problem, state, cache);
  const auto& system = *kept;
  state.solution.q = Vector::Zero(system.dofs);
  state.solution.interiors.assign(system.bodies.size(), {});
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (const auto* body = std::get_if<body::NonlinearBody>(&system.bodies[b]))
      state.solution.interiors[b] = body->start();
  state.solution.contacts.clear();
  for (const auto& setup : system.contacts) state.solution.contacts.push_back(contact::fresh_state(setup));
  approach(problem, state, system);
  state.approached = true;
  for (char rigid : problem.rigid) state.counts.factorisations += rigid ? 0 : 1;
}

Outcome play_increments(const Problem& problem, State state, Cache& cache, const BlockSpan& span,
                        const Observer& observer) {
  const auto& output = problem.scene.output;
  Playing block{span, observer, state.factors,
                history_due(output.history_every_blocks, state.step_blocks + 1, span.last)};
  if (under_tolerance(*span.step)) {
    block.at_start = removed_volumes(state.solution.contacts);
    block.worn.cycles = span.jump;
  }
  cache.newton.reset();
  if (span.continued)
    if (auto failure = settle_ahead(problem, state, cache, span, 1.0, 0.0, problem.scene.max_cutbacks);
        !failure.empty())
      return {std::move(state), std::move(failure), false};
  begin_watch(problem, state);
  const auto ends = span.ends.empty() ? increment_ends(problem.scene, *span.step) : span.ends;
  double from = 0.0;
  if (span.cycles && state.step_cycles == 0.0 &&
      factors_at(problem.scene.histories, *span.step, 0.0, block.held) != block.held)
    if (const auto failure = play(problem, state, cache, block, 0.0, 0.0, 0); !failure.empty())
      return {std::move(state), failure, false};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::string failure = play(problem, state, cache, block, from, ends[i], problem.scene.max_cutbacks);
    if (!failure.empty()) return {std::move(state), failure, false};
    from = ends[i];
    tell_progress(block, problem, state, *cache.system, static_cast<int>(i) + 1, static_cast<int>(ends.size()), from);
    const bool shown_here = output.frames.every_increment || (output.frames.last_block && span.last);
    if (shown_here && i + 1 < ends.size()) {
      const double start = state.cycle;
      state.cycle = cycle_at(span, start, from);
      show_frame(problem, state, cache, observer, span.step->name);
      state.cycle = start;
    }
    if (observer.interrupted && observer.interrupted()) {
      if (span.cycles) state.cycle += span.jump * from;
      return {std::move(state), {}, true};
    }
  }
  if (span.cycles) {
    state.cycle += span.jump;
    ++state.counts.cycles_solved;
  }
  return {std::move(state), {}, false, {}, std::move(block.ends), std::move(block.worn)};
}

Outcome end_block(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer) {
  Outcome outcome{std::move(state), {}, false};
  if (problem.scene.shape && (span.step->wear || problem.scene.remesh.every_blocks > 0))
    outcome = wear_down(problem, std::move(outcome.state), cache, span, observer);
  if (!outcome.failure.empty()) return outcome;
  if (problem.scene.shape && span.step->wear) measure_depths(problem, outcome.state);
  renew_references(problem, outcome.state, cache, span, observer);
  return outcome;
}

Outcome play_block(const Problem& problem, const State& state, Cache& cache, const BlockSpan& span,
                   const Observer& observer) {
  Outcome outcome = play_increments(problem, state, cache, span, observer);
  if (!outcome.failure.empty() || outcome.interrupted) return outcome;
  return end_block(problem, std::move(outcome.state), cache, span, observer);
}

}  // namespace reye::sim
