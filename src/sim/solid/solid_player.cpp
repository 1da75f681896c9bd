#include "sim/solid/solid_player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/formatted.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/free_bodies.hpp"
#include "sim/solid/skin_depth.hpp"
#include "sim/solid/solid_drive.hpp"
#include "sim/solid/solid_increments.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/solid/warn_solid.hpp"
#include "solver/solid/fit_gaps.hpp"

namespace reye::sim {

namespace {

constexpr std::size_t most_cutback_reasons = 20;
constexpr int rings_of_growth = 4;

/// Largest worn depth of all contacts [mm].
double deepest(const solver::SolidSystem& system, const SolidRunState& state) {
  double depth = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& wear = state.solution.wear[c];
    if (setup.options.wear.wears())
      depth = std::max({depth, deepest_worn(setup, wear, Side::secondary), deepest_worn(setup, wear, Side::primary)});
  }
  return depth;
}

}  // namespace

/// A play while it runs.
struct SolidPlayer::Playing {
  const SolidSpan& span;
  const SolidObserver& observer;
  SolidOutcome outcome;
  Volumes at_start{};  ///< removed; empty: the course is not noted

  double cycle_at(double progress) const { return outcome.state.cycle + (span.cycles ? span.jump * progress : 0.0); }
};

SolidPlayer::SolidPlayer(const SolidProblem& problem, SolidRunState& state, std::optional<SolidAssembly> assembly)
    : problem_(problem),
      increments_(solid_increments(problem)),
      touchable_(state.touchable),
      assembly_(std::move(assembly)) {
  if (assembly_)
    state.factor_s += assembly_->seconds;
  else
    build(state);
  if (!state.fitted) fit(state);
}

void SolidPlayer::assemble_bodies(SolidRunState& state) {
  auto before = std::exchange(assembly_, std::nullopt);  // there are none where a body cannot be factorised
  assembly_.emplace(assemble(problem_, state.meshes, touchable_, std::move(before)));
  state.factor_s += assembly_->seconds;
  state.counts.factorisations += assembly_->factorised;
}

void SolidPlayer::build(SolidRunState& state) {
  assemble_bodies(state);
  if (state.solution.traction.empty()) {
    state.solution = solver::initial_state(system());
    state.points = points_of(system());
    state.block_wear = state.solution.wear;
    for (const auto& setup : system().contacts) state.slid.emplace_back(static_cast<std::size_t>(setup.count()), 0);
  }
  bring_up(state);
}

/// Carries a state onto the present points.
void SolidPlayer::bring_up(SolidRunState& state) const {
  state.retained = system().points();
  state.touchable = touchable_;
  auto points = points_of(system());
  if (points == state.points) return;
  state.solution = carried(state.points, system(), state.solution);
  state.block_wear = carried_wear(state.points, system(), state.block_wear);
  state.solved.reset();  // it has the points of the equations before
  state.last_wear = {};
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
  fit(state);
}

void SolidPlayer::show_on(SolidRunState& state, SolidMeshes meshes) {
  bring_up(state);
  state.meshes = std::move(meshes);
  set_contacts(problem_, state.meshes, *assembly_);
  state.fitted = false;
}

void SolidPlayer::fit(SolidRunState& state) const {
  state.solution.u = solver::displacements_of(system(), state.solution);  // what sticks is held to these
  solver::fit_gaps(system(), state.solution);
  state.fitted = true;
}

void SolidPlayer::redraw(SolidRunState& state, SolidMeshes meshes, Touchable touchable) {
  state.meshes = std::move(meshes);
  touchable_ = state.touchable = std::move(touchable);
  assemble_bodies(state);
  state.retained = system().points();
  state.solved.reset();
  state.last_wear = {};
}

SolidOutcome SolidPlayer::play(SolidRunState state, const SolidSpan& span, const SolidObserver& observer) {
  bring_up(state);
  Playing play{span, observer, {std::move(state), {}, false}};
  auto& now = play.outcome.state;
  play.outcome.cycle = now.cycle;
  if (under_tolerance(*span.step)) {
    play.at_start = removed_volumes(now.solution.wear);
    play.outcome.worn.cycles = span.jump;
  }
  const auto ends = solid_increment_ends(problem_.scene, *span.step);
  const auto count = static_cast<int>(ends.size());
  if (now.increment == 0) play.outcome.failure = settle_ahead(now, span);
  if (!play.outcome.failure.empty()) return std::move(play.outcome);
  while (now.increment < count) {
    const auto k = static_cast<std::size_t>(now.increment);
    play.outcome.failure = play_between(play, k > 0 ? ends[k - 1] : 0.0, ends[k], problem_.scene.max_cutbacks);
    if (!play.outcome.failure.empty()) return std::move(play.outcome);
    if (++now.increment == count) break;
    show_inside(play, ends[k]);
    if (observer.state) observer.state(now);
    if (observer.interrupted && observer.interrupted()) {
      play.outcome.interrupted = true;
      return std::move(play.outcome);
    }
  }
  now.increment = 0;
  if (span.cycles) {
    now.cycle += span.jump;
    ++now.counts.cycles_solved;
  }
  return std::move(play.outcome);
}

/// A frame at the end of an increment, where the scene asks for those.
void SolidPlayer::show_inside(const Playing& play, double to) const {
  const auto& rules = problem_.scene.frames;
  if (play.observer.frame && (rules.every_increment || (rules.last_block && play.span.last)))
    play.observer.frame(solid_frame(problem_, *assembly_, play.outcome.state, play.span.step->name,
                                    {play.cycle_at(to), to, rules.paraview}));
}

/// One increment; on failure it is halved, up to `depth` times.
std::string SolidPlayer::play_between(Playing& play, double from, double to, int depth) {
  auto& state = play.outcome.state;
  const auto factors = factors_at(problem_.scene.histories, *play.span.step, to, state.factors);
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
  play.outcome.cycle = play.cycle_at(to);
  play.outcome.progress = to;
  return {};
}

/// Empty where the increment is solved; contact that outruns its touchable nodes gets more of them.
std::string SolidPlayer::solve(Playing& play, const std::map<std::string, double>& factors, double from, double to) {
  auto& state = play.outcome.state;
  const solver::SolidOptions options{.max_newton = problem_.scene.max_newton};
  for (;;) {
    const auto target = target_at(problem_, system(), state.solution, factors, *play.span.step,
                                  {state.cycle, play.span.jump, play.span.continued}, from, to);
    auto solution = solver::solve_increment(system(), state.solution, target, options);
    state.mortar_s += solution.mortar_s;
    state.interface_s += solution.interface_s;
    state.counts.newton_iterations += solution.iterations;
    if (!solution.converged)
      return solution.loose ? free_bodies_in_words(system()) + " (" + solution.reason + ")" : solution.reason;
    if (outrun(system(), solution) && grow(problem_, state.meshes, touchable_, rings_of_growth)) {
      if (play.observer.log) play.observer.log("contact outruns the nodes it was prepared for: more of them are kept");
      build(state);
      continue;
    }
    state.solved = std::move(solution);
    return {};
  }
}

void SolidPlayer::accept(Playing& play, const std::map<std::string, double>& factors, double to) {
  auto& state = play.outcome.state;
  state.solution = state.solved->state;
  state.factors = factors;
  ++state.counts.increments;
  const auto forces = balance_of_bodies(problem_, system(), *state.solved);
  state.imbalance_N = std::max(state.imbalance_N, forces.left_N);
  state.largest_force_N = std::max(state.largest_force_N, forces.largest_N);
  if (state.largest_force_N > 0.0) state.balance = state.imbalance_N / state.largest_force_N;
  watch_solid(problem_, system(), *state.solved, state.warnings);
  note_course(play, to);
  record(play, to);
}

/// Notes what the play has worn so far; no more where points come to the contacts.
void SolidPlayer::note_course(Playing& play, double to) {
  const auto removed = removed_volumes(play.outcome.state.solution.wear);
  if (same_sizes(removed, play.at_start)) play.outcome.worn.note(to, removed, play.at_start);
}

void SolidPlayer::record(const Playing& play, double to) const {
  const auto& state = play.outcome.state;
  const auto& step = *play.span.step;
  if (play.observer.increment && play.span.recorded) {
    SolidIncrement row = row_of(problem_, system(), state);
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
  p.newton = state.solved->iterations;
  p.increments = std::max(1, step.increments);
  p.increment = static_cast<int>(std::lround(to * p.increments));
  p.depth_max_mm = deepest(system(), state);
  p.fraction = play.span.cycles ? (state.step_cycles + play.span.jump * to) / step.cycles : to;
  p.solved = static_cast<double>(state.counts.increments);
  p.to_be_solved = std::max(0.0, increments_ - p.solved);
  play.observer.progress(p);
}

SolidIncrement row_of(const SolidProblem& problem, const solver::SolidSystem& system, const SolidRunState& state) {
  SolidIncrement row;
  row.newton = state.solved->iterations;
  row.errors = state.solved->errors;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) row.contacts.push_back(contact_row(system, state, c));
  row.supports = support_rows(problem, system, *state.solved);
  return row;
}

}  // namespace reye::sim
