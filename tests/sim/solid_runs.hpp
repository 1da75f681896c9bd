#pragma once
#include "support/solid_hertz.hpp"

/// Small runs of solids for tests of their states.
namespace reye::test {

/// A ball rubbed to and fro on a flat for two cycles of four increments after two that press it; its fine zone is so
/// small that contact outruns it.
inline sim::SolidProblem rubbed_ball() {
  support::HertzCase c;
  c.mu = 0.5;
  c.half = true;
  c.elements = 2.0;
  auto problem = support::hertz_problem(c, 0.5 * c.mu * c.force());
  problem.scene.geometry.fine_zones[0].radius_mm = 0.1 * c.a_mm;
  problem.scene.histories["slide"] = {{0.0, 0.0}, {0.25, 1.0}, {0.75, -1.0}, {1.0, 0.0}};
  problem.scene.steps = {support::step_of(2, {"press"}), support::step_of(4, {"slide"}, 2)};
  problem.scene.frames.last_block = true;
  problem.scene.frames.paraview = false;
  return problem;
}

/// A run with its states, and how many rows and frames there were at each.
struct KeptStates {
  support::PlayedSolids played;
  std::vector<sim::SolidRunState> states;
  std::vector<std::size_t> rows, frames;
};

/// Plays from a state, or from the start; `interrupted_at`: the run is asked to end once it has kept so many states.
inline KeptStates play_and_keep(const sim::SolidProblem& problem, std::optional<sim::SolidRunState> state = {},
                                std::optional<sim::SolidAssembly> assembly = {}, std::size_t interrupted_at = 0) {
  KeptStates kept;
  auto& played = kept.played;
  sim::SolidObserver observer;
  observer.increment = [&](const sim::SolidIncrement& row) { played.rows.push_back(row); };
  observer.frame = [&](const sim::SolidFrame& frame) { played.frames.push_back(frame); };
  observer.state = [&](const sim::SolidRunState& at) {
    kept.states.push_back(at);
    kept.rows.push_back(played.rows.size());
    kept.frames.push_back(played.frames.size());
  };
  observer.interrupted = [&] { return kept.states.size() == interrupted_at; };
  played.summary =
      sim::run_solid(problem, state ? *state : sim::initial_solid_state(problem), observer, std::move(assembly));
  return kept;
}

}  // namespace reye::test
