#include "sim/run.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "base/errors.hpp"
#include "sim/block.hpp"
#include "sim/discretisation.hpp"
#include "sim/jump.hpp"
#include "sim/kinematics.hpp"
#include "sim/measure.hpp"
#include "sim/rules.hpp"
#include "sim/stick_edge.hpp"
#include "sim/timer.hpp"
#include "sim/warn_contact.hpp"
#include "sim/warnings.hpp"

namespace reye::sim {

namespace {

using clock = std::chrono::steady_clock;

double peak_rss_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Cycles still to be played in a step.
double remaining(const scene::Step& step, const State& state) { return step.cycles - state.step_cycles; }

bool step_over(const scene::Step& step, const State& state) {
  return step.cycles > 0.0 ? remaining(step, state) <= 1e-9 * step.cycles : state.step_blocks > 0;
}

bool controlled(const scene::Step& step) { return step.cycles > 0.0 && step.jump_tolerance > 0.0 && step.wear; }

/// What the next block is tried with. Under a tolerance two blocks share what is left when one is not enough.
BlockSpan next_span(const scene::Step& step, const State& state) {
  BlockSpan span;
  span.step = &step;
  span.cycles = step.cycles > 0.0;
  span.last = true;
  if (!span.cycles) return span;
  const double left = remaining(step, state);
  double jump = step.jump;
  if (controlled(step)) {
    jump = std::min(state.jump > 0.0 ? state.jump : step.jump, step.jump_most);
    if (jump < left && left < 2.0 * jump) jump = 0.5 * left;
  }
  span.jump = std::min(jump, left);
  span.last = left - span.jump <= 1e-9 * step.cycles;
  return span;
}

/// Where between 0 and 1 a measure passes a bound: linear, or the parabola through its value half way.
double crossing(double bound, double before, std::optional<double> middle, double after) {
  if (!middle) return (bound - before) / (after - before);
  const auto value = [&](double t) {
    return before * (1.0 - t) * (1.0 - 2.0 * t) + *middle * 4.0 * t * (1.0 - t) + after * t * (2.0 * t - 1.0);
  };
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k) (value(0.5 * (low + high)) < bound ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

double bound_of(const scene::Limit& limit) { return limit.depth_mm ? *limit.depth_mm : *limit.area_mm2; }

/// Notes limits that were crossed in the last block, between the values of their measures; true: one of them ends the run.
bool watch_limits(const Problem& problem, State& state, const solver::System& system, double cycle_before,
                  const std::map<std::string, double>& middle) {
  bool stop = false;
  const auto measures = limit_measures(problem, system, state);
  for (const auto& limit : problem.scene.limits) {
    const double now = measures.at(limit.name), before = state.limit_measure[limit.name];
    const double bound = bound_of(limit);
    state.limit_measure[limit.name] = now;
    if (now < bound || state.life_cycles.contains(limit.name)) continue;
    const auto half_way = middle.find(limit.name);
    const double cycles = state.cycle - cycle_before;
    const double at = crossing(bound, before, half_way == middle.end() ? std::nullopt : std::optional(half_way->second), now);
    state.life_cycles[limit.name] = cycle_before + cycles * at;
    if (state.jump_error) state.life_error[limit.name] = *state.jump_error * bound * cycles / (now - before);
    stop = stop || limit.stop;
  }
  return stop;
}

void probe(const Problem& problem, const Frame& frame, Summary& summary) {
  for (const auto& p : problem.scene.output.probes)
    for (const auto& body : frame.bodies) {
      if (body.name != p.body) continue;
      const auto& X = body.mesh->X;
      std::size_t best = 0;
      for (std::size_t i = 1; i < X.size(); ++i)
        if ((X[i] - p.at_mm).squaredNorm() < (X[best] - p.at_mm).squaredNorm()) best = i;
      summary.probes[p.name] = body.u[best];
    }
}

std::string in_words(const MeshError& error) {
  if (!error.surface) return "no estimate of the mesh's error: " + error.reason;
  char text[120];
  std::snprintf(text, sizeof text, "estimated error of the mesh %.3g %%", 100.0 * *error.surface);
  std::string words = text;
  if (!error.peak_pressure) return words;
  std::snprintf(text, sizeof text, ", of the peak pressure %.3g %%", 100.0 * *error.peak_pressure);
  return words + text;
}

/// One run in progress: the loop over steps and blocks.
class Runner {
 public:
  Runner(const Problem& problem, State& state, const Observer& observer, Cache& cache)
      : p_(problem), state_(state), observer_(observer), cache_(cache) {
    solver::NewtonOptions options;
    options.max_iterations = problem.scene.max_newton;
    cache_.newton = solver::Newton(options);
  }

  Summary go() {
    const auto start = clock::now();
    const double cpu = cpu_seconds();
    play();
    if (p_.scene.output.estimate_error && summary_.status == RunStatus::done) estimate();
    Summary s = summarise_run();
    s.wall_s = std::chrono::duration<double>(clock::now() - start).count();
    s.cpu_s = cpu_seconds() - cpu + cache_.cpu_s;
    s.peak_rss_MB = peak_rss_MB();
    return s;
  }

 private:
  void play() {
    try {
      if (!state_.approached) {
        begin_state(p_, state_, cache_);
        show("start");
      }
      while (state_.step < static_cast<int>(p_.scene.steps.size())) {
        const auto& step = p_.scene.steps[state_.step];
        if (step_over(step, state_)) {
          ++state_.step;
          state_.step_cycles = 0.0;
          state_.step_blocks = 0;
          continue;
        }
        if (!next_block(step)) return;
      }
    } catch (const base::SolveError& error) {
      fail(error.what());
    } catch (const base::MeshError& error) {
      fail(error.what());
    }
  }

  /// False when the run ends here.
  bool next_block(const scene::Step& step) {
    const double cycle_before = state_.cycle;
    const long remeshes_before = state_.counts.remeshes;
    const BlockSpan span = next_span(step, state_);
    const auto slip_before = slip_paths(state_);
    Outcome outcome = controlled(step) ? play_controlled(p_, state_, cache_, span, observer_)
                                       : play_block(p_, state_, cache_, span, observer_);
    state_ = std::move(outcome.state);
    if (!outcome.failure.empty()) return fail(outcome.failure);
    if (outcome.interrupted) {
      summary_.status = RunStatus::interrupted;
      summary_.reason = "interrupted in step \"" + step.name + "\" at cycle " + std::to_string(state_.cycle);
      show(step.name);
      return false;
    }
    state_.step_cycles += state_.cycle - cycle_before;
    ++state_.step_blocks;
    ++state_.counts.blocks;
    watch_strain();
    if (step.wear && span.cycles && state_.counts.remeshes == remeshes_before)
      warn_of_stick_edge(p_, system_of(p_, state_, cache_), slip_before, state_, observer_);
    warn_of_block(p_, state_, observer_);
    const bool stop = watch_limits(p_, state_, system_of(p_, state_, cache_), cycle_before, outcome.middle);
    const bool last = stop || step_over(step, state_);
    const bool remeshed = state_.counts.remeshes > remeshes_before;
    if (frame_due(p_.scene.output.frames, {cycle_before, state_.cycle, state_.step_blocks, last, remeshed})) show(step.name);
    if (observer_.block) observer_.block(state_);
    return !stop;
  }

  /// Small strain that the trial found good enough may cease to be so as bodies wear.
  void watch_strain() {
    const auto now = small_strain_error(p_, state_, system_of(p_, state_, cache_));
    const double before = state_.small_strain_error.value_or(0.0);
    if (!now || *now <= before) return;
    state_.small_strain_error = now;
    if (before > small_strain_bound || *now <= small_strain_bound || !observer_.log) return;
    char text[160];
    std::snprintf(text, sizeof text, "warning: cycle %g: small strain was chosen, but its estimated error is now "
                  "%.2g %%; kinematics = \"finite\" is without it", state_.cycle, 100.0 * *now);
    observer_.log(text);
  }

  bool fail(const std::string& reason) {
    summary_.status = RunStatus::failed;
    summary_.reason = reason;
    if (observer_.log) observer_.log("failed: " + reason);
    show("last good state");
    return false;
  }

  /// What the mesh puts wrong; an interruption here leaves a run that goes on with the estimate.
  void estimate() {
    const MeshError error = mesh_error(p_, state_, cache_, observer_);
    summary_.error_discretisation = error.surface;
    summary_.error_peak_pressure = error.peak_pressure;
    summary_.error_energy_norm = error.energy_norm;
    if (error.companion == RunStatus::interrupted) {
      summary_.status = RunStatus::interrupted;
      summary_.reason = error.reason;
    } else if (observer_.log) {
      observer_.log(in_words(error));
    }
  }

  void show(const std::string& step) {
    if (state_.approached) show_frame(p_, state_, cache_, observer_, step);
  }

  Summary summarise_run() {
    Summary& s = summary_;
    s.title = p_.scene.title;
    s.cycles = state_.cycle;
    s.analysis = p_.scene.analysis;
    s.scene_sha256 = p_.scene.sha256;
    s.skipped = p_.plan.skipped;
    s.cutback_reasons = state_.cutback_reasons;
    for (const auto& limit : p_.scene.limits) {
      const auto found = state_.life_cycles.find(limit.name);
      const bool reached = found != state_.life_cycles.end();
      s.life_cycles[limit.name] = reached ? std::optional(found->second) : std::nullopt;
      s.limit_share[limit.name] = state_.limit_measure[limit.name] / bound_of(limit);
      if (!limit.wear_factor) continue;
      s.life_band[limit.name] = {};
      const auto& [lowest, highest] = *limit.wear_factor;
      if (reached) s.life_band[limit.name] = {found->second / highest, found->second / lowest};
    }
    if (state_.approached) {
      const auto& system = system_of(p_, state_, cache_);
      for (std::size_t c = 0; c < system.contacts.size(); ++c)
        s.contacts.push_back(summarise(system.contacts[c], state_.solution.contacts[c], state_.shapes, p_.contacts[c]));
      warn_of_run(p_, state_, s, observer_);
      if (!p_.scene.output.probes.empty()) probe(p_, make_frame(p_, state_, cache_, ""), s);
    }
    s.warnings = p_.warnings;
    for (const auto& warning : state_.warnings) warn(s.warnings, warning);
    s.life_error = state_.life_error;
    s.error_cycle_jump = state_.jump_error;
    s.error_small_strain = state_.small_strain_error;
    s.counts = state_.counts;
    s.room_seconds = cache_.seconds;
    return s;
  }

  const Problem& p_;
  State& state_;
  const Observer& observer_;
  Cache& cache_;
  Summary summary_;
};

}  // namespace

Summary run(const Problem& problem, State& state, const Observer& observer, Cache& cache) {
  return Runner(problem, state, observer, cache).go();
}

Summary run(const Problem& problem, State& state, const Observer& observer) {
  Cache cache;
  return run(problem, state, observer, cache);
}

}  // namespace reye::sim
