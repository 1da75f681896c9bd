#include "sim/study/scar_run.hpp"

#include <algorithm>

#include "sim/measure/measure.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/surfaces.hpp"
#include "sim/problem/system.hpp"
#include "sim/solid/solid_observer.hpp"
#include "sim/solid/solid_problem.hpp"
#include "sim/study/prepare.hpp"
#include "sim/study/run.hpp"
#include "sim/study/solid_accuracy.hpp"

namespace reye::sim {

namespace {

using scene::MeasuredFigure;
using scene::MeasuredScars;
using scene::ScarFigure;
using scene::ScarSide;

/// Coefficients scaled, the wearing step as long as the run may take, and nothing that ends it or is written.
void set_up(auto& scene, const WearFactors& factors, double cycles) {
  for (auto& contact : scene.contacts) {
    contact.wear.secondary *= factors.secondary;
    contact.wear.primary *= factors.primary;
  }
  for (auto& step : scene.steps)
    if (step.wear && cycles > 0.0) step.cycles = cycles;
  scene.limits.clear();
}

/// The place of a contact of the scene by its name.
std::size_t index_of(const auto& contacts, const std::string& name) {
  const auto found = std::find_if(contacts.begin(), contacts.end(), [&](const auto& c) { return c.name == name; });
  return static_cast<std::size_t>(found - contacts.begin());
}

/// The energy of one cycle, from what the contacts have dissipated at the ends of two blocks.
class CycleEnergy {
 public:
  /// At the end of a block.
  void reach(double cycle, std::vector<double> dissipated) {
    per_cycle_.assign(dissipated.size(), 0.0);
    for (std::size_t c = 0; c < before_.size() && cycle > cycle_; ++c)
      per_cycle_[c] = (dissipated[c] - before_[c]) / (cycle - cycle_);
    before_ = std::move(dissipated);
    cycle_ = cycle;
  }
  double of(std::size_t contact) const { return per_cycle_[contact]; }

 private:
  std::vector<double> before_, per_cycle_;
  double cycle_ = 0.0;
};

double value_of(const SideSummary& side, ScarFigure what) {
  return what == ScarFigure::depth   ? side.max_depth_mm
         : what == ScarFigure::width ? side.scar_width_mm
                                     : side.worn_area;
}

double value_of(const SkinContactRow& row, const MeasuredFigure& figure) {
  const bool primary = figure.of.side == ScarSide::primary;
  if (figure.what == ScarFigure::depth) return primary ? row.depth_primary_mm : row.depth_secondary_mm;
  return primary ? row.volume_primary_mm3 : row.volume_secondary_mm3;
}

/// Adds the states after blocks to all families.
class Recorder {
 public:
  Recorder(const MeasuredScars& measured, ScarRun& run) : measured_(measured), run_(run) {
    run.families.resize(measured.scars.size() + measured.figures.size());
  }

  void reach(const Problem& problem, const State& state, const solver::System& system) {
    std::vector<double> dissipated;
    for (const auto& contact : state.solution.contacts) dissipated.push_back(contact.frictional_work);
    energy_.reach(state.cycle, std::move(dissipated));
    if (!(state.cycle > run_.cycles)) return;
    run_.cycles = state.cycle;
    run_.counts = state.counts;
    const auto shown = as_shown(problem, state);
    auto family = run_.families.begin();
    for (const auto& scar : measured_.scars) {
      const auto c = index_of(problem.scene.contacts, scar.of.contact);
      const auto sides = surface_records(system.contacts[c], shown[c], state.shapes, problem.contacts[c]);
      (family++)->add(state.cycle, profile_of(sides[scar.of.side == ScarSide::primary], scar.axes.front()));
    }
    for (const auto& figure : measured_.figures) {
      const auto c = index_of(problem.scene.contacts, figure.of.contact);
      const auto all = summarise(system.contacts[c], shown[c], state.shapes, problem.contacts[c]);
      const auto& side = figure.of.side == ScarSide::primary ? all.primary : all.secondary;
      (family++)->add(state.cycle, figure.what == ScarFigure::energy ? number_of(energy_.of(c), false)
                                                                     : number_of(value_of(side, figure.what)));
    }
  }

  void reach(const SolidProblem& problem, const SolidFrame& frame, const SolidIncrement& row) {
    std::vector<double> dissipated;
    for (const auto& contact : row.contacts) dissipated.push_back(contact.energy_mJ);
    energy_.reach(frame.cycle, std::move(dissipated));
    if (!(frame.cycle > run_.cycles)) return;
    run_.cycles = frame.cycle;
    auto family = run_.families.begin();
    for (const auto& scar : measured_.scars) {
      const auto side = scar.of.side == ScarSide::primary ? Side::primary : Side::secondary;
      for (const auto& surface : frame.surfaces)
        if (surface.contact == scar.of.contact && surface.side == side)
          family->add(frame.cycle, map_of(surface, scar.axes));
      ++family;
    }
    for (const auto& figure : measured_.figures) {
      const auto c = index_of(problem.scene.contacts, figure.of.contact);
      (family++)->add(frame.cycle, figure.what == ScarFigure::energy ? number_of(energy_.of(c), false)
                                                                     : number_of(value_of(row.contacts[c], figure)));
    }
  }

 private:
  const MeasuredScars& measured_;
  ScarRun& run_;
  CycleEnergy energy_;
};

/// How a run ended: one that was stopped because enough was played has not failed.
void end(const auto& summary, bool stopped, ScarRun& run) {
  run.counts = summary.counts;
  run.jump_error = summary.error_cycle_jump;
  run.warnings = summary.warnings;
  if (summary.status != RunStatus::done && !stopped) run.failure = summary.reason;
}

}  // namespace

ScarRun play_scars(scene::Scene scene, const MeasuredScars& measured, const WearFactors& factors, double cycles,
                   const ScarStop& stop) {
  set_up(scene, factors, cycles);
  scene.output.frames = {.every_cycles = 1e18};
  scene.output.estimate_error = false;
  scene.output.probes.clear();
  Cache cache;
  const Problem problem = prepare(scene, &cache);
  State state = initial_state(problem);
  ScarRun result;
  Recorder recorder(measured, result);
  bool stopped = false;
  Observer observer;
  observer.block = [&](const State& now) {
    if (!stopped) recorder.reach(problem, now, *system_of(problem, now, cache));
    stopped = stopped || (result.cycles > 0.0 && stop.enough(result));
  };
  observer.interrupted = [&] { return stopped || (stop.interrupted && stop.interrupted()); };
  const auto summary = run(problem, state, observer, cache);
  end(summary, stopped, result);
  return result;
}

ScarRun play_scars(scene::SolidScene scene, const MeasuredScars& measured, const WearFactors& factors, double cycles,
                   const ScarStop& stop) {
  set_up(scene, factors, cycles);
  scene.frames = {.every_blocks = 1};
  scene.estimate_error = false;
  scene.probes.clear();
  const SolidProblem problem = prepare(scene);
  ScarRun result;
  Recorder recorder(measured, result);
  bool stopped = false;
  SolidIncrement last;
  SolidObserver observer;
  observer.increment = [&](const SolidIncrement& row) { last = row; };
  observer.frame = [&](const SolidFrame& frame) {
    if (!stopped && !last.contacts.empty()) recorder.reach(problem, frame, last);
    stopped = stopped || (result.cycles > 0.0 && stop.enough(result));
  };
  observer.interrupted = [&] { return stopped || (stop.interrupted && stop.interrupted()); };
  const auto summary = run(problem, initial_solid_state(problem), observer);
  end(summary, stopped, result);
  return result;
}

}  // namespace reye::sim
