#include "sim/march/march.hpp"

#include <algorithm>
#include <cstdio>

#include "base/errors.hpp"
#include "sim/march/block.hpp"
#include "sim/march/fixed_jump.hpp"
#include "sim/march/held_row.hpp"
#include "sim/march/jump.hpp"
#include "sim/march/recording.hpp"
#include "sim/march/stick_edge.hpp"
#include "sim/march/watch_block.hpp"
#include "sim/march/watch_jump.hpp"
#include "sim/march/work.hpp"
#include "sim/measure/bond_traction.hpp"
#include "sim/measure/corners.hpp"
#include "sim/measure/frame.hpp"
#include "sim/measure/limits.hpp"
#include "sim/measure/measure.hpp"
#include "sim/measure/probe.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/warn_contact.hpp"
#include "sim/problem/ending.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/span.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/reshape/shape.hpp"

namespace reye::sim {

namespace {

/// The span with which the next block is tried.
BlockSpan next_span(const Problem& problem, const scene::Step& step, const State& state) {
  const auto& frames = problem.scene.output.frames;
  BlockSpan span;
  span.step = &step;
  span.cycles = step.cycles > 0.0;
  span.last = true;
  if (!span.cycles) return span;
  const double left = remaining(step, state);
  if (under_tolerance(step))
    span.jump = fitted(frames, state.cycle, std::min(state.jump > 0.0 ? state.jump : step.jump, step.jump_most), left);
  else
    span.jump = std::min(left, next_fixed(problem, step, state));
  span.last = left - span.jump <= 1e-9 * step.cycles;
  const double done = state.step_cycles / step.cycles;
  span.level = frame_due(frames, {.cycle_before = state.cycle,
                                  .cycle = state.cycle + span.jump,
                                  .number = state.step_blocks + 1,
                                  .last = span.last,
                                  .share_before = done,
                                  .share = done + span.jump / step.cycles});
  return span;
}

constexpr int most_turns = 4;  ///< times that a block is repeated to end at a limit

/// One run in progress: the loop over steps and blocks.
class Runner {
 public:
  Runner(const Problem& problem, State& state, const Observer& observer, Cache& cache)
      : p_(problem), state_(state), row_(observer), observer_(row_.observer()), cache_(cache) {
    solver::NewtonOptions options;
    options.max_iterations = problem.scene.max_newton;
    cache_.newton = solver::Newton(options);
  }

  Summary go() {
    play();
    row_.release();
    return summarise_run();
  }

 private:
  void play() {
    try {
      play_steps();
    } catch (const base::SolveError& error) {
      fail(error.what());
    } catch (const base::MeshError& error) {
      fail(error.what());
    }
  }

  void play_steps() {
    if (!state_.approached) {
      begin_state(p_, state_, cache_);
      show("start");
    }
    while (state_.step < static_cast<int>(p_.scene.steps.size())) {
      const auto& step = p_.scene.steps[state_.step];
      if (step_over(step, state_))
        begin_next_step();
      else if (at_end(p_, state_) || !next_block(step))
        return;
    }
  }

  void begin_next_step() {
    ++state_.step;
    state_.step_cycles = 0.0;
    state_.step_blocks = 0;
    state_.block_cycles = 0.0;
    state_.last_wear = {};
  }

  Outcome play(const BlockSpan& span, const State& from, const Observer& observer) {
    return under_tolerance(*span.step) ? play_controlled(p_, from, cache_, span, observer)
                                       : play_fixed(p_, from, cache_, span, observer);
  }

  /// Plays a block; where it should end at a limit in its midst it is repeated, as far as the limit.
  Outcome play_to_limit(BlockSpan span) {
    if (!span.cycles || !any_limit_ahead(p_.scene.limits, state_.life_cycles)) return play(span, state_, observer_);
    const double tolerance = under_tolerance(*span.step) ? span.step->jump_tolerance : 0.0;
    Recording recording;
    Outcome outcome = play(span, state_, recording.observer(observer_));
    for (int turn = 0; turn < most_turns && outcome.failure.empty() && !outcome.interrupted; ++turn) {
      const auto end = block_end(p_, state_, outcome.state, *system_of(p_, outcome.state, cache_), outcome.middle,
                                 tolerance, turn > 0);
      const double played = outcome.state.cycle - state_.cycle;
      if (!end || played <= unjumped) break;
      State start = state_;
      keep_counts(start, outcome.state.counts);
      span.jump = std::max(unjumped, end->share * played);
      span.last = span.level = end->stop;
      if (observer_.log) observer_.log(block_repeated(*span.step, start.cycle, span.jump, *end));
      recording = {};
      outcome = play(span, start, recording.observer(observer_));
    }
    recording.play_back(observer_);
    return outcome;
  }

  /// Sets the end of a step to exactly its last cycle, without the rounding of the sum of its blocks.
  void end_on_the_cycle(const scene::Step& step) {
    state_.cycle += remaining(step, state_);
    state_.step_cycles = step.cycles;
  }

  /// What the end of a block is compared with.
  struct BlockStart {
    double cycle = 0.0, largest_plastic = 0.0, mean_plastic = 0.0;
    Counts counts;
    std::vector<std::vector<double>> slip;
    Volumes removed;
  };

  bool remeshed_since(const BlockStart& start) const { return state_.counts.remeshes > start.counts.remeshes; }

  /// Warns of what a block shows; it is in the state already.
  void watch_block(const scene::Step& step, const BlockStart& start) {
    const bool same_meshes = !remeshed_since(start);
    const double solved = static_cast<double>(state_.counts.cycles_solved - start.counts.cycles_solved);
    if (step.cycles > 0.0 && same_meshes)
      watch_plastic_strain(step, start.largest_plastic, (state_.cycle - start.cycle) / solved, state_, observer_);
    if (step.wear && step.cycles > 0.0 && same_meshes)
      warn_of_stick_edge(p_, *system_of(p_, state_, cache_), start.slip, state_, observer_);
    warn_of_block(p_, state_, observer_);
    for (auto& warning : corner_warnings(*system_of(p_, state_, cache_), state_))
      warn(state_, observer_, std::move(warning));
  }

  /// False when the run ends here.
  bool next_block(const scene::Step& step) {
    const BlockStart start{
        state_.cycle,       largest_plastic_strain(state_),           mean_plastic_strain(state_), state_.counts,
        slip_paths(state_), removed_volumes(state_.solution.contacts)};
    BlockSpan span = next_span(p_, step, state_);
    if (observer_.progress)
      span.increments_of_run = static_cast<double>(state_.counts.increments) + work_left(p_, state_).increments;
    Outcome outcome = play_to_limit(std::move(span));
    state_ = std::move(outcome.state);
    if (!outcome.failure.empty()) return fail(outcome.failure);
    if (outcome.interrupted) return interrupt(step);
    state_.step_cycles += state_.cycle - start.cycle;
    if (step.cycles > 0.0 && step_over(step, state_)) end_on_the_cycle(step);
    row_.settle(p_, state_, *system_of(p_, state_, cache_), step);
    ++state_.step_blocks;
    ++state_.counts.blocks;
    state_.flow = flow_since(state_, start.mean_plastic, !remeshed_since(start));
    if (const auto reason =
            watch_strain(p_, state_, *system_of(p_, state_, cache_), step_over(step, state_), observer_);
        !reason.empty())
      return fail(reason);
    watch_block(step, start);
    return end_block_of(step, start, outcome.middle);
  }

  /// Judges the limits and shows the end of a block. `middle`: measures of the limits half way, where known.
  bool end_block_of(const scene::Step& step, const BlockStart& start, const std::map<std::string, double>& middle) {
    const bool stop = watch_limits(p_, state_, *system_of(p_, state_, cache_), start.cycle, middle);
    const bool last = stop || step_over(step, state_);
    if (last && under_tolerance(step)) watch_tolerance(step, state_, observer_);
    if (last)
      watch_jump(p_, state_, cache_, step, remeshed_since(start) ? Volumes{} : start.removed,
                 state_.cycle - start.cycle, observer_);
    PlayedBlock played{start.cycle, state_.cycle, state_.step_blocks, last, remeshed_since(start)};
    if (step.cycles > 0.0) {
      played.share = state_.step_cycles / step.cycles;
      played.share_before = played.share - (state_.cycle - start.cycle) / step.cycles;
    }
    if (frame_due(p_.scene.output.frames, played)) show(step.name);
    if (observer_.block) observer_.block(state_);
    return !stop;
  }

  bool interrupt(const scene::Step& step) {
    summary_.status = RunStatus::interrupted;
    summary_.reason = "interrupted in step \"" + step.name + "\" at cycle " + std::to_string(state_.cycle);
    show(step.name);
    return false;
  }

  bool fail(const std::string& reason) {
    summary_.status = RunStatus::failed;
    summary_.reason = reason;
    if (observer_.log) observer_.log("failed: " + reason);
    show_last_good();
    return false;
  }

  /// Shows the state that a failed run ends with, worn; it stays what a run may resume from.
  void show_last_good() {
    if (!state_.approached || state_.shown || !observer_.frame) return;
    State worn = worn_by_what_waits(p_, state_, cache_, p_.scene.steps.at(static_cast<std::size_t>(state_.step)));
    show_frame(p_, worn, cache_, observer_, "last good state");
    state_.shown = worn.shown;
    state_.warnings = std::move(worn.warnings);
  }

  void show(const std::string& step) {
    if (state_.approached) show_frame(p_, state_, cache_, observer_, step);
  }

  void summarise_limit(const scene::Limit& limit) {
    const auto found = state_.life_cycles.find(limit.name);
    const bool reached = found != state_.life_cycles.end();
    summary_.life_cycles[limit.name] = reached ? std::optional(found->second) : std::nullopt;
    summary_.limit_share[limit.name] = state_.limit_measure[limit.name] / bound_of(limit);
    if (!limit.wear_factor) return;
    summary_.life_band[limit.name] = {};
    const auto& [lowest, highest] = *limit.wear_factor;
    if (reached) summary_.life_band[limit.name] = {found->second / highest, found->second / lowest};
  }

  void summarise_joints() {
    const auto kept = system_of(p_, state_, cache_);
    const auto& system = *kept;
    const auto shown = as_shown(p_, state_);
    for (std::size_t c = 0; c < p_.contacts.size(); ++c)
      summary_.contacts.push_back(summarise(system.contacts[c], shown[c], state_.shapes, p_.contacts[c]));
    summary_.bonds = bond_summaries(p_, state_, system);
    warn_of_run(p_, state_, summary_, observer_);
    if (!p_.scene.output.probes.empty()) summary_.probes = probes(p_, state_, make_frame(p_, state_, cache_, ""));
  }

  void summarise_errors() {
    summary_.life_error = state_.life_error;
    summary_.error_cycle_jump = state_.jump_error;
    summary_.error_small_strain = state_.small_strain_error;
  }

  Summary summarise_run() {
    Summary& s = summary_;
    s.title = p_.scene.title;
    s.cycles = state_.cycle;
    s.analysis = p_.scene.analysis;
    s.scene_sha256 = p_.scene.sha256;
    s.skipped = p_.plan.skipped;
    for (const auto& [name, h] : p_.scene.measured)
      s.histories[name] = {h.points, h.corners.size(), h.tolerance, h.way_lost};
    s.cutback_reasons = state_.cutback_reasons;
    for (const auto& limit : p_.scene.limits) summarise_limit(limit);
    if (state_.approached) summarise_joints();
    s.warnings = p_.warnings;
    for (const auto& warning : state_.warnings) warn(s.warnings, warning);
    summarise_errors();
    s.counts = state_.counts;
    s.room_seconds = cache_.seconds;
    return s;
  }

  const Problem& p_;
  State& state_;
  HeldRow row_;
  const Observer& observer_;
  Cache& cache_;
  Summary summary_;
};

}  // namespace

Summary march(const Problem& problem, State& state, const Observer& observer, Cache& cache) {
  return Runner(problem, state, observer, cache).go();
}

}  // namespace reye::sim
