#include "sim/solid/solid_march.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/errors.hpp"
#include "sim/measure/limits.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/solid_correction.hpp"
#include "sim/solid/solid_jump.hpp"
#include "sim/solid/solid_limits.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/solid/solid_recording.hpp"
#include "sim/solid/solid_reshape.hpp"
#include "sim/solid/solid_stick_edge.hpp"
#include "sim/solid/solid_watch_jump.hpp"

namespace reye::sim {

namespace {

constexpr double round_off = 1e-9;  ///< of the cycles of a step
constexpr int most_turns = 4;       ///< times that a block is repeated to end at a limit

/// A run while it is played.
class March {
 public:
  March(const SolidProblem& problem, SolidRunState state, const SolidObserver& observer,
        std::optional<SolidAssembly> assembly)
      : problem_(problem), observer_(observer), planned_(solid_plan(problem).size), state_(std::move(state)) {
    const double made_s = assembly ? assembly->seconds : 0.0;
    before_s_ = problem.mesh_seconds + made_s;
    try {
      player_.emplace(problem_, state_, std::move(assembly));
    } catch (const base::SolveError& error) {
      failure_ = error.what();
    }
  }

  SolidSummary play() {
    try {
      if (player_) play_steps();
    } catch (const base::SolveError& error) {
      failure_ = error.what();
    }
    end();
    return summary();
  }

 private:
  void play_steps() {
    while (!at_end(problem_, state_)) {
      const auto& step = problem_.scene.steps[static_cast<std::size_t>(state_.step)];
      if (is_over(step, state_)) {
        ++state_.step;
        state_.step_cycles = state_.block_cycles = 0.0;
        state_.step_blocks = 0;
        state_.last_wear = {};
      } else if (!next_block(step)) {
        return;
      }
    }
  }

  /// A state from before contact got more nodes has values of fewer; where there are no equations nothing more is said
  /// of contacts. A run that does not come to its end shows the last good state.
  void end() {
    if (player_ && player_->has_equations())
      state_ = player_->brought_up(std::move(state_));
    else
      state_.solved.reset();
    if (!failure_.empty() && observer_.log) observer_.log("failed: " + failure_);
    if (!failure_.empty()) show("last good state", within_.value_or(Within{state_.cycle, 1.0}));
  }

  /// A moment of a play.
  struct Within {
    double cycle, progress;
  };

  void show(const std::string& step, const Within& at) {
    if (observer_.frame && state_.solved)
      observer_.frame(solid_frame(problem_, player_->assembly(), state_, step,
                                  {at.cycle, at.progress, problem_.scene.frames.paraview}));
  }

  /// The span with which the next block is tried.
  SolidSpan next_span(const scene::Step& step) const {
    SolidSpan span{.step = &step, .jump = 1.0, .cycles = step.cycles > 0.0, .last = true};
    if (!span.cycles) return span;
    const double left = cycles_left(step, state_);
    if (under_tolerance(step))
      span.jump = fitted(problem_.scene.frames, state_.cycle, std::min(jump_to_try(step), step.jump_most), left);
    else
      span.jump = std::min(state_.block_cycles > 0.0 ? state_.block_cycles : step.jump, left);
    span.last = left - span.jump <= round_off * step.cycles;
    span.recorded = history_due(problem_.scene.history_every_blocks, state_.step_blocks + 1, span.last);
    span.level = frame_due(problem_.scene.frames,
                           block_of(step, now(), {state_.cycle + span.jump, state_.step_cycles + span.jump},
                                    state_.step_blocks + 1, span.last));
    return span;
  }

  /// The cycles that a block under a tolerance is tried with. However exact its wear, no block wears more than a part
  /// of an element: the shape could not follow.
  double jump_to_try(const scene::Step& step) const {
    constexpr double most_share = 0.3;
    const double jump = state_.jump > 0.0 ? state_.jump : step.jump;
    if (!problem_.scene.shape || !(state_.share_per_cycle > 0.0)) return jump;
    return std::min(jump, std::max(1.0, most_share / state_.share_per_cycle));
  }

  /// Cycles of the run, and of its present step.
  struct Reached {
    double cycle, of_step;
  };
  Reached now() const { return {state_.cycle, state_.step_cycles}; }

  static PlayedBlock block_of(const scene::Step& step, Reached before, Reached after, long number, bool last) {
    PlayedBlock block{before.cycle, after.cycle, number, last, false};
    if (step.cycles > 0.0) {
      block.share_before = before.of_step / step.cycles;
      block.share = after.of_step / step.cycles;
    }
    return block;
  }

  SolidOutcome play_span(const SolidSpan& span, const SolidRunState& from, const SolidObserver& observer) {
    return under_tolerance(*span.step) ? play_controlled_block(problem_, *player_, from, span, observer)
                                       : play_fixed_block(*player_, from, span, observer);
  }

  /// Plays a block; where it should end at a limit in its midst it is repeated, as far as the limit.
  SolidOutcome play_to_limit(SolidSpan span) {
    if (!span.cycles || !any_limit_ahead(problem_.scene.limits, state_.life_cycles))
      return play_span(span, state_, observer_);
    const double tolerance = under_tolerance(*span.step) ? span.step->jump_tolerance : 0.0;
    SolidRecording recording;
    SolidOutcome outcome = play_span(span, state_, recording.observer(observer_));
    for (int turn = 0; turn < most_turns && outcome.failure.empty() && !outcome.interrupted; ++turn) {
      const auto end =
          solid_block_end(problem_, player_->system(), state_, outcome.state, outcome.middle, tolerance, turn > 0);
      const double cycles = outcome.state.cycle - state_.cycle;
      if (!end || cycles <= 1.0) break;
      SolidRunState start = state_;
      start.counts = outcome.state.counts;
      span.jump = std::max(1.0, end->share * cycles);
      span.last = span.level = end->stop;
      if (observer_.log) observer_.log(block_repeated(*span.step, start.cycle, span.jump, *end));
      recording = {};
      outcome = play_span(span, start, recording.observer(observer_));
    }
    if (outcome.interrupted) outcome.state = state_;
    recording.play_back(observer_);
    return outcome;
  }

  /// False when the run ends here.
  bool next_block(const scene::Step& step) {
    if (state_.increment == 0) state_.block_wear = state_.solution.wear;
    const Reached before = now();
    const double waiting = pending_share(player_->system(), state_);
    SolidOutcome outcome = play_to_limit(next_span(step));
    state_ = std::move(outcome.state);
    failure_ = outcome.failure;
    if (!failure_.empty()) within_ = {outcome.cycle, outcome.progress};
    interrupted_ = outcome.interrupted;
    if (!failure_.empty() || interrupted_) return false;
    finish_block(step, before.cycle);
    if (step.wear && step.cycles > 0.0) warn_of_stick_edge(problem_, player_->system(), state_, observer_);
    const bool stop = watch_solid_limits(problem_, player_->system(), before.cycle, outcome.middle, state_);
    const bool last = stop || is_over(step, state_);
    if (last) watch_jump(problem_, *player_, state_, step, state_.cycle - before.cycle, observer_);
    const double share = pending_share(player_->system(), state_);
    if (const double cycles = state_.cycle - before.cycle; cycles > 0.0)
      state_.share_per_cycle = std::max(0.0, share - waiting) / cycles;
    const long remeshes = state_.counts.remeshes;
    if (problem_.scene.shape && !move_shapes(step, share)) return false;
    auto block = block_of(step, before, now(), state_.step_blocks, last);
    block.remeshed = state_.counts.remeshes > remeshes;
    if (frame_due(problem_.scene.frames, block)) show(step.name, {state_.cycle, 1.0});
    if (at_end(problem_, state_)) state_.probes = probe_values(problem_, player_->assembly(), state_);
    return keep();
  }

  /// Shows the state, from which a run can resume; false where this one is to end with it.
  bool keep() {
    if (observer_.state) observer_.state(state_);
    interrupted_ = !at_end(problem_, state_) && observer_.interrupted && observer_.interrupted();
    return !interrupted_;
  }

  /// Moves the worn faces where the depth that waits in the gaps, a `share` of the facets, is no longer small, and at
  /// the end of the run, and remeshes. False where a body cannot follow.
  bool move_shapes(const scene::Step& step, double share) {
    constexpr double small = 0.02;
    const bool moves = share > (at_end(problem_, state_) ? 0.0 : small);
    if (!moves && !remesh_due(problem_, state_)) return true;
    failure_ = reshape_bodies(problem_, *player_, relocations_, step, observer_, state_);
    return failure_.empty();
  }

  void finish_block(const scene::Step& step, double cycle_before) {
    const double cycles = state_.cycle - cycle_before;
    state_.step_cycles += cycles;
    if (step.cycles > 0.0 && is_over(step, state_)) {
      state_.cycle += cycles_left(step, state_);
      state_.step_cycles = step.cycles;
    }
    ++state_.step_blocks;
    ++state_.counts.blocks;
    state_.slid = slid_between(state_.block_wear, state_.solution.wear);
    if (step.cycles > 0.0)
      for (std::size_t c = 0; c < state_.energy_last_cycle_mJ.size(); ++c)
        state_.energy_last_cycle_mJ[c] = (energy_of(state_, c) - state_.block_wear[c].frictional_work) / cycles;
  }

  void summarise_limits(SolidSummary& s) const {
    for (const auto& limit : problem_.scene.limits) {
      const auto life = state_.life_cycles.find(limit.name);
      const bool reached = life != state_.life_cycles.end();
      s.life_cycles[limit.name] = reached ? std::optional(life->second) : std::nullopt;
      const auto measure = state_.limit_measure.find(limit.name);
      s.limit_share[limit.name] = measure == state_.limit_measure.end() ? 0.0 : measure->second / bound_of(limit);
      if (!limit.wear_factor) continue;
      const auto& [lowest, highest] = *limit.wear_factor;
      s.life_band[limit.name] = reached ? LifeBand{life->second / highest, life->second / lowest} : LifeBand{};
    }
    s.life_error = state_.life_error;
    s.error_cycle_jump = state_.jump_error;
  }

  SolidSummary summary() {
    SolidSummary s;
    s.title = problem_.scene.title;
    s.status = !failure_.empty() ? RunStatus::failed : interrupted_ ? RunStatus::interrupted : RunStatus::done;
    s.reason = interrupted_ ? "interrupted" : failure_;
    s.cycles = state_.cycle;
    s.counts = state_.counts;
    s.balance = state_.balance;
    s.cutback_reasons = state_.cutback_reasons;
    s.scene_sha256 = problem_.scene.sha256;
    s.warnings = problem_.warnings;
    s.warnings.insert(s.warnings.end(), state_.warnings.begin(), state_.warnings.end());
    if (state_.solved) {
      for (std::size_t c = 0; c < problem_.contacts.size(); ++c)
        s.contacts.push_back(contact_summary(problem_, player_->system(), state_, c));
      const bool kept = failure_.empty() && at_end(problem_, state_);
      s.probes = kept ? state_.probes : probe_values(problem_, player_->assembly(), state_);
    }
    summarise_limits(s);
    s.size = planned_;
    s.size.retained = state_.retained;
    s.phase_seconds = {{"mesh", problem_.mesh_seconds},
                       {"stiffness and factors", state_.factor_s},
                       {"mortar", state_.mortar_s},
                       {"interface", state_.interface_s},
                       {"shape", state_.shape_s}};
    s.cpu_s = cpu_seconds() - start_cpu_ + before_s_;
    s.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_wall_).count() + before_s_;
    s.peak_rss_MB = peak_memory_MB();
    return s;
  }

  const SolidProblem& problem_;
  const SolidObserver& observer_;
  std::chrono::steady_clock::time_point start_wall_ = std::chrono::steady_clock::now();
  double start_cpu_ = cpu_seconds(), before_s_ = 0.0;  ///< CPU: when the run began, and of what was made before
  SolidSize planned_;
  SolidRunState state_;
  std::optional<SolidPlayer> player_;
  SolidRelocations relocations_;
  std::string failure_;
  std::optional<Within> within_;  ///< where a play has failed
  bool interrupted_ = false;
};

}  // namespace

SolidSummary run_solid(const SolidProblem& problem, SolidRunState state, const SolidObserver& observer,
                       std::optional<SolidAssembly> assembly) {
  return March(problem, std::move(state), observer, std::move(assembly)).play();
}

SolidSummary run_solid(const SolidProblem& problem, const SolidObserver& observer) {
  return run_solid(problem, initial_solid_state(problem), observer);
}

}  // namespace reye::sim
