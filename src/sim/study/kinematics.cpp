#include "sim/study/kinematics.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "body/turning.hpp"
#include "fem/frame.hpp"
#include "sim/march/march.hpp"
#include "sim/measure/small_strain.hpp"
#include "sim/place/place.hpp"
#include "sim/problem/observer.hpp"

namespace reye::sim {

namespace {

/// Each step once and without wear, from corner to corner of its histories unless a body is nonlinear or turns and may
/// need the increments asked for.
Problem trial_of(const Problem& problem) {
  Problem trial = problem;
  bool stepwise = false;
  for (int b = 0; b < trial.body_count(); ++b)
    stepwise = stepwise || (!trial.rigid[b] &&
                            (is_nonlinear(trial.inputs[b]) || body::pivot_of(trial.shapes[b]->mesh, trial.inputs[b])));
  auto& scene = trial.scene;
  scene.steps.clear();
  std::set<std::string> played;
  for (scene::Step step : problem.scene.steps) {
    if (!played.insert(step.name).second) continue;
    step.wear = false;
    step.cycles = 0.0;
    if (!stepwise) step.increments = 1;
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
        keep_largest(*choices[b], fem::distortion(*body.mesh, trial.scene.analysis,
                                                  fem::in_frame(body.mesh->X, body.u, body.angle_rad)));
  };
  watch.interrupted = over;
  const Summary summary = march(trial, state, watch, cache);
  for (std::size_t b = 0; b < choices.size(); ++b) {
    if (!choices[b]) continue;
    if (summary.status == RunStatus::failed) choices[b]->failure = summary.reason;
    const bool finite = decided(choices[b]) || !choices[b]->failure.empty();
    problem.scene.body_material.at(problem.inputs[b].name).kinematics =
        finite ? base::Kinematics::finite : base::Kinematics::small;
    take_material(problem.scene, problem.inputs[b]);
  }
}

}  // namespace reye::sim
