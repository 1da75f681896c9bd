#include "sim/solid/solid_player.hpp"

#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/free_bodies.hpp"
#include "sim/solid/solid_drive.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/solid/warn_solid.hpp"

namespace reye::sim {

namespace {

constexpr std::size_t most_cutback_reasons = 20;
constexpr int rings_of_growth = 4;

}  // namespace

/// A play while it runs.
struct SolidPlayer::Playing {
  const SolidSpan& span;
  const SolidObserver& observer;
  SolidOutcome outcome;
  std::map<std::string, double> held;
  double increments_of_run = 0.0;

  double cycle_at(double progress) const { return outcome.state.cycle + (span.cycles ? span.jump * progress : 0.0); }
};

SolidPlayer::SolidPlayer(const SolidProblem& problem) : problem_(problem), touchable_(touchable_nodes(problem)) {}

SolidRunState SolidPlayer::begin() {
  SolidRunState state;
  for (const auto& [name, corners] : problem_.scene.histories) state.factors[name] = 0.0;
  for (const auto& input : problem_.inputs) state.meshes.push_back(input.mesh);
  state.energy_last_cycle_mJ.assign(problem_.contacts.size(), 0.0);
  build(state);
  return state;
}

void SolidPlayer::build(SolidRunState& state) {
  const bool first = !assembly_;
  assembly_.emplace(assemble(problem_, state.meshes, touchable_, std::move(assembly_)));
  state.factor_s += assembly_->seconds;
  state.counts.factorisations += assembly_->factorised;
  if (first) {
    state.solution = solver::initial_state(system());
    state.points = points_of(system());
    for (const auto& setup : system().contacts) state.slid.emplace_back(static_cast<std::size_t>(setup.count()), 0);
  }
  bring_up(state);
}

/// Carries a state onto the present points.
void SolidPlayer::bring_up(SolidRunState& state) const {
  state.retained = system().points();
  auto points = points_of(system());
  if (points == state.points) return;
  state.solution = carried(state.points, system(), state.solution);
  state.points = std::move(points);
  for (std::size_t c = 0; c < state.slid.size(); ++c) state.slid[c].assign(state.points[c].secondary.size(), 0);
}

SolidRunState SolidPlayer::brought_up(SolidRunState state) const {
  bring_up(state);
  return state;
}

void SolidPlayer::reshape(SolidRunState& state, SolidMeshes meshes) {
  bring_up(state);
  state.meshes = std::move(meshes);
  build(state);
  state.solution.u = solver::displacements_of(system(), state.solution);
}

SolidOutcome SolidPlayer::play(SolidRunState state, const SolidSpan& span, const SolidObserver& observer) {
  bring_up(state);
  Playing play{span, observer, {std::move(state), {}, {}, false}, {}, 0.0};
  play.held = play.outcome.state.factors;
  if (observer.progress) play.increments_of_run = solid_increments(problem_);
  double from = 0.0;
  for (const double to : step_corners(problem_.scene.histories, *span.step)) {
    play.outcome.failure = play_between(play, from, to, problem_.scene.max_cutbacks);
    if (!play.outcome.failure.empty()) return std::move(play.outcome);
    from = to;
    if (observer.interrupted && observer.interrupted()) {
      play.outcome.interrupted = true;
      return std::move(play.outcome);
    }
    const auto& rules = problem_.scene.frames;
    if (to < 1.0 && observer.frame && (rules.every_increment || (rules.last_block && span.last)))
      observer.frame(solid_frame(problem_, *assembly_, *play.outcome.solution, play.outcome.state, span.step->name,
                                 {play.cycle_at(to), to, rules.paraview}));
  }
  if (span.cycles) {
    play.outcome.state.cycle += span.jump;
    ++play.outcome.state.counts.cycles_solved;
  }
  return std::move(play.outcome);
}

/// One increment; on failure it is halved, up to `depth` times.
std::string SolidPlayer::play_between(Playing& play, double from, double to, int depth) {
  auto& state = play.outcome.state;
  const auto factors = factors_at(problem_.scene.histories, *play.span.step, to, play.held);
  if (auto failure = solve(play, factors, from, to); !failure.empty()) {
    const std::string where =
        base::formatted("step \"%s\", cycle %.9g, progress %.4g to %.4g: ", play.span.step->name.c_str(), state.cycle,
                        from, to) +
        failure;
    if (depth == 0) return where;
    ++state.counts.cutbacks;
    if (state.cutback_reasons.size() < most_cutback_reasons) state.cutback_reasons.push_back(where);
    if (play.observer.log) play.observer.log("cut back: " + where);
    const double middle = 0.5 * (from + to);
    if (auto first = play_between(play, from, middle, depth - 1); !first.empty()) return first;
    return play_between(play, middle, to, depth - 1);
  }
  accept(play, factors, to);
  return {};
}

/// Empty where the increment is solved; contact that outruns its touchable nodes gets more of them.
std::string SolidPlayer::solve(Playing& play, const std::map<std::string, double>& factors, double from, double to) {
  auto& state = play.outcome.state;
  const solver::SolidOptions options{.max_newton = problem_.scene.max_newton};
  for (;;) {
    const auto target = target_at(problem_, system(), state.solution, factors, *play.span.step,
                                  {state.cycle, play.span.jump}, from, to);
    auto solution = solver::solve_increment(system(), state.solution, target, options);
    state.mortar_s += solution.mortar_s;
    state.interface_s += solution.interface_s;
    state.counts.newton_iterations += solution.iterations;
    if (!solution.converged)
      return solution.loose ? free_bodies_in_words(system()) + " (" + solution.reason + ")" : solution.reason;
    if (outrun(system(), solution) && grow(problem_, touchable_, rings_of_growth)) {
      if (play.observer.log) play.observer.log("contact outruns the nodes it was prepared for: more of them are kept");
      build(state);
      continue;
    }
    play.outcome.solution = std::move(solution);
    return {};
  }
}

void SolidPlayer::accept(Playing& play, const std::map<std::string, double>& factors, double to) {
  auto& state = play.outcome.state;
  state.solution = play.outcome.solution->state;
  state.factors = factors;
  ++state.counts.increments;
  state.balance = std::max(state.balance, imbalance_of_bodies(problem_, system(), *play.outcome.solution));
  watch_solid(problem_, system(), *play.outcome.solution, warnings_);
  record(play, to);
}

void SolidPlayer::record(const Playing& play, double to) const {
  const auto& state = play.outcome.state;
  const auto& step = *play.span.step;
  if (play.observer.increment && play.span.recorded) {
    SolidIncrement row = row_of(problem_, system(), *play.outcome.solution, state);
    row.step = step.name;
    row.cycle = play.cycle_at(to);
    row.progress = to;
    play.observer.increment(row);
  }
  if (!play.observer.progress) return;
  Progress p;
  p.step = step.name;
  p.cycle = play.cycle_at(to);
  p.cycles = step.cycles;
  p.newton = play.outcome.solution->iterations;
  p.increments = std::max(1, step.increments);
  p.increment = static_cast<int>(std::lround(to * p.increments));
  p.fraction = play.span.cycles ? (state.step_cycles + play.span.jump * to) / step.cycles : to;
  p.solved = static_cast<double>(state.counts.increments);
  p.to_be_solved = std::max(0.0, play.increments_of_run - p.solved);
  play.observer.progress(p);
}

SolidIncrement row_of(const SolidProblem& problem, const solver::SolidSystem& system,
                      const solver::SolidSolution& solution, const SolidRunState& state) {
  SolidIncrement row;
  row.newton = solution.iterations;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    row.contacts.push_back(contact_row(system, solution, c, state));
  row.supports = support_rows(problem, system, solution);
  return row;
}

}  // namespace reye::sim
