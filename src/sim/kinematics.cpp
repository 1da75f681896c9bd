#include "sim/kinematics.hpp"

#include <algorithm>
#include <set>

#include "sim/run.hpp"
#include "sim/shape.hpp"

namespace reye::sim {

namespace {

bool small(const body::BodyInput& input) { return input.kinematics == base::Kinematics::small; }

/// Each step once and without wear, from corner to corner of its histories unless a body is nonlinear and may need the
/// increments asked for.
Problem trial_of(const Problem& problem) {
  Problem trial = problem;
  bool nonlinear = false;
  for (int b = 0; b < trial.body_count(); ++b)
    nonlinear = nonlinear || (!trial.rigid[b] && is_nonlinear(trial.inputs[b]));
  auto& scene = trial.scene;
  scene.steps.clear();
  std::set<std::string> played;
  for (scene::Step step : problem.scene.steps) {
    if (!played.insert(step.name).second) continue;
    step.wear = false;
    step.cycles = 0.0;
    if (!nonlinear) step.increments = 1;
    scene.steps.push_back(step);
  }
  scene.limits.clear();
  scene.output = {};
  scene.output.frames.every_increment = true;
  scene.remesh.automatic = false;
  scene.remesh.every_blocks = 0;
  return trial;
}

void keep_largest(KinematicsChoice& choice, const fem::Distortion& now) {
  if (now.error() > choice.largest.error()) choice.largest = now;
}

void take_finite(body::BodyInput& input) {
  input.kinematics = base::Kinematics::finite;
  if (const auto* linear = std::get_if<material::LinearElastic>(&input.material))
    input.material = material::Hencky{linear->E_MPa, linear->nu};
}

}  // namespace

void choose_kinematics(Problem& problem, Cache& cache) {
  auto& choices = problem.kinematics;
  const auto decided = [](const auto& choice) { return !choice || choice->largest.error() > small_strain_bound; };
  const auto over = [&] { return std::all_of(choices.begin(), choices.end(), decided); };
  if (over()) return;
  Problem trial = trial_of(problem);
  State state = initial_state(trial);
  Observer watch;
  watch.frame = [&](const Frame& frame) {
    for (std::size_t b = 0; b < choices.size(); ++b)
      if (const auto& body = frame.bodies[b]; choices[b])
        keep_largest(*choices[b], fem::distortion(*body.mesh, trial.scene.analysis, body.u));
  };
  watch.interrupted = over;
  const Summary summary = run(trial, state, watch, cache);
  for (std::size_t b = 0; b < choices.size(); ++b) {
    if (!choices[b]) continue;
    if (summary.status == RunStatus::failed) choices[b]->failure = summary.reason;
    if (!decided(choices[b]) && choices[b]->failure.empty()) continue;
    take_finite(problem.inputs[b]);
    cache.shapes.clear();
  }
}

std::optional<double> chosen_small_error(const Problem& problem) {
  std::optional<double> largest;
  for (std::size_t b = 0; b < problem.kinematics.size(); ++b)
    if (const auto& choice = problem.kinematics[b]; choice && small(problem.inputs[b]))
      largest = std::max(largest.value_or(0.0), choice->largest.error());
  return largest;
}

std::optional<double> small_strain_error(const Problem& problem, const State& state, const solver::System& system) {
  std::optional<double> largest;
  for (int b = 0; b < problem.body_count(); ++b)
    if (problem.kinematics[b] && small(problem.inputs[b])) {
      const auto u = recovered(problem, state, system, b);
      const auto now = fem::distortion(state.shapes[b]->mesh, problem.scene.analysis, u);
      largest = std::max(largest.value_or(0.0), now.error());
    }
  return largest;
}

}  // namespace reye::sim
