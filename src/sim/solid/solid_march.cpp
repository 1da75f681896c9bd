#include "sim/solid/solid_march.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
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

/// A run while it is played.
class March {
 public:
  March(const SolidProblem& problem, const SolidObserver& observer)
      : problem_(problem),
        observer_(observer),
        touchable_(touchable_nodes(problem)),
        planned_(solid_plan(problem).size) {
    for (const auto& [name, corners] : problem.scene.histories) state_.factors[name] = 0.0;
    state_.energy_mJ.assign(problem.contacts.size(), 0.0);
    state_.energy_before_cycle_mJ = state_.energy_last_cycle_mJ = state_.energy_mJ;
    start_wall_ = std::chrono::steady_clock::now();
    start_cpu_ = cpu_seconds();
  }

  SolidSummary play() {
    std::string failure;
    try {
      build();
      failure = play_steps();
    } catch (const base::SolveError& error) {
      failure = error.what();
    }
    return summary(failure);
  }

 private:
  void build() {
    SolidAssembly fresh = assemble(problem_, touchable_);
    state_.factor_s += fresh.seconds;
    ++state_.counts.factorisations;
    if (assembly_)
      state_.solution = carried(*assembly_, fresh, state_.solution);
    else
      state_.solution = solver::initial_state(fresh.system);
    assembly_.emplace(std::move(fresh));
    state_.retained = assembly_->system.points();
  }

  std::string play_steps() {
    const auto& steps = problem_.scene.steps;
    for (state_.step = 0; state_.step < static_cast<int>(steps.size()); ++state_.step) {
      const auto& step = steps[static_cast<std::size_t>(state_.step)];
      const int plays = std::max(1, static_cast<int>(std::lround(step.cycles)));
      for (int cycle = 0; cycle < plays; ++cycle) {
        if (auto failure = play_once(step, cycle + 1 == plays); !failure.empty()) return failure;
        if (interrupted_) return {};
      }
    }
    return {};
  }

  std::string play_once(const scene::Step& step, bool last) {
    const auto held = state_.factors;
    state_.energy_before_cycle_mJ = state_.energy_mJ;
    double from = 0.0;
    for (const double to : solid_increment_ends(problem_.scene, step)) {
      if (auto failure = play_between(step, held, from, to, problem_.scene.max_cutbacks); !failure.empty())
        return failure;
      if (observer_.interrupted && observer_.interrupted()) {
        interrupted_ = true;
        return {};
      }
      from = to;
      show(step, last, to);
    }
    ++state_.counts.blocks;
    if (step.cycles > 0.0) {
      state_.cycle += 1.0;
      ++state_.counts.cycles_solved;
      for (std::size_t c = 0; c < state_.energy_mJ.size(); ++c)
        state_.energy_last_cycle_mJ[c] = state_.energy_mJ[c] - state_.energy_before_cycle_mJ[c];
    }
    return {};
  }

  /// One increment; on failure it is halved, up to `depth` times.
  std::string play_between(const scene::Step& step, const std::map<std::string, double>& held, double from, double to,
                           int depth) {
    const auto factors = factors_at(problem_.scene.histories, step, to, held);
    if (auto failure = solve(step, factors, from, to); !failure.empty()) {
      const std::string where = base::formatted("step \"%s\", cycle %.9g, progress %.4g to %.4g: ", step.name.c_str(),
                                                state_.cycle, from, to) +
                                failure;
      if (depth == 0) return where;
      ++state_.counts.cutbacks;
      if (state_.cutback_reasons.size() < most_cutback_reasons) state_.cutback_reasons.push_back(where);
      if (observer_.log) observer_.log("cut back: " + where);
      const double middle = 0.5 * (from + to);
      if (auto first = play_between(step, held, from, middle, depth - 1); !first.empty()) return first;
      return play_between(step, held, middle, to, depth - 1);
    }
    accept(step, factors, to);
    return {};
  }

  /// Empty where the increment is solved; contact that outruns its touchable nodes gets more of them.
  std::string solve(const scene::Step& step, const std::map<std::string, double>& factors, double from, double to) {
    const solver::SolidOptions options{.max_newton = problem_.scene.max_newton};
    for (;;) {
      const auto& system = assembly_->system;
      const auto target = target_at(problem_, system, state_.solution, factors, step, from, to);
      auto solution = solver::solve_increment(system, state_.solution, target, options);
      state_.mortar_s += solution.mortar_s;
      state_.interface_s += solution.interface_s;
      state_.counts.newton_iterations += solution.iterations;
      if (!solution.converged) return why(solution);
      if (outrun(system, solution) && grow(problem_, touchable_, rings_of_growth)) {
        if (observer_.log) observer_.log("contact outruns the nodes it was prepared for: more of them are kept");
        build();
        continue;
      }
      solution_ = std::move(solution);
      return {};
    }
  }

  std::string why(const solver::SolidSolution& failure) const {
    return failure.loose ? free_bodies_in_words(assembly_->system) + " (" + failure.reason + ")" : failure.reason;
  }

  void accept(const scene::Step& step, const std::map<std::string, double>& factors, double to) {
    const auto energy = dissipated(*solution_);
    for (std::size_t c = 0; c < energy.size(); ++c) state_.energy_mJ[c] += energy[c];
    state_.solution = solution_->state;
    state_.factors = factors;
    ++state_.counts.increments;
    state_.balance = std::max(state_.balance, imbalance_of_bodies(problem_, assembly_->system, *solution_));
    watch_solid(problem_, assembly_->system, *solution_, warnings_);
    record(step, to);
  }

  void record(const scene::Step& step, double to) {
    if (observer_.increment) {
      SolidIncrement row{step.name, state_.cycle + (step.cycles > 0.0 ? to : 0.0), to, solution_->iterations, {}, {}};
      for (std::size_t c = 0; c < problem_.contacts.size(); ++c)
        row.contacts.push_back(contact_row(*solution_, c, problem_.contacts[c].options.friction, state_.energy_mJ[c]));
      row.supports = support_rows(problem_, assembly_->system, *solution_);
      observer_.increment(row);
    }
    if (observer_.progress) observer_.progress(progress_of(step, to));
  }

  Progress progress_of(const scene::Step& step, double to) const {
    Progress p;
    p.step = step.name;
    p.cycle = state_.cycle + (step.cycles > 0.0 ? to : 0.0);
    p.cycles = step.cycles;
    p.newton = solution_->iterations;
    p.increments = std::max(1, step.increments);
    p.increment = static_cast<int>(std::lround(to * p.increments));
    p.fraction = to;
    p.solved = static_cast<double>(state_.counts.increments);
    p.to_be_solved = std::max(0.0, solid_increments(problem_) - p.solved);
    return p;
  }

  /// Frames at the end of each step, of every increment where that is asked for, and as the rules of a step say.
  void show(const scene::Step& step, bool last, double to) {
    if (!observer_.frame) return;
    const auto& rules = problem_.scene.frames;
    const bool counted = rules.per_step > 0 && step.cycles > 0.0 && to == 1.0 &&
                         std::fmod(state_.cycle + 1.0, std::max(1.0, std::ceil(step.cycles / rules.per_step))) == 0.0;
    const bool end = last && to == 1.0;
    if (!(end || counted || rules.every_increment || (rules.last_block && last))) return;
    SolidRunState at = state_;
    at.cycle += step.cycles > 0.0 ? to : 0.0;
    observer_.frame(solid_frame(problem_, *assembly_, *solution_, at, step.name, to, rules.paraview));
  }

  SolidSummary summary(const std::string& failure) {
    SolidSummary s;
    s.title = problem_.scene.title;
    s.status = !failure.empty() ? RunStatus::failed : interrupted_ ? RunStatus::interrupted : RunStatus::done;
    s.reason = interrupted_ ? "interrupted" : failure;
    s.cycles = state_.cycle;
    s.counts = state_.counts;
    s.balance = state_.balance;
    s.cutback_reasons = state_.cutback_reasons;
    s.scene_sha256 = problem_.scene.sha256;
    s.warnings = problem_.warnings;
    s.warnings.insert(s.warnings.end(), warnings_.begin(), warnings_.end());
    if (solution_) {
      for (std::size_t c = 0; c < problem_.contacts.size(); ++c)
        s.contacts.push_back(contact_summary(problem_, assembly_->system, *solution_, c, state_));
      s.probes = probe_values(problem_, *assembly_, *solution_);
    }
    s.size = planned_;
    s.size.retained = state_.retained;
    s.phase_seconds = {{"mesh", problem_.mesh_seconds},
                       {"stiffness and factors", state_.factor_s},
                       {"mortar", state_.mortar_s},
                       {"interface", state_.interface_s}};
    s.cpu_s = cpu_seconds() - start_cpu_ + problem_.mesh_seconds;
    s.wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_wall_).count() + problem_.mesh_seconds;
    s.peak_rss_MB = peak_memory_MB();
    return s;
  }

  const SolidProblem& problem_;
  const SolidObserver& observer_;
  Touchable touchable_;
  SolidSize planned_;
  std::optional<SolidAssembly> assembly_;
  std::optional<solver::SolidSolution> solution_;
  SolidRunState state_;
  std::vector<Warning> warnings_;
  bool interrupted_ = false;
  std::chrono::steady_clock::time_point start_wall_;
  double start_cpu_ = 0.0;
};

}  // namespace

SolidSummary run_solid(const SolidProblem& problem, const SolidObserver& observer) {
  return March(problem, observer).play();
}

}  // namespace reye::sim
