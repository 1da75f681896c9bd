#include "sim/kinematics.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "body/turning.hpp"
#include "fem/frame.hpp"
#include "sim/run.hpp"
#include "sim/scene_line.hpp"
#include "sim/shape.hpp"
#include "sim/warnings.hpp"

namespace reye::sim {

namespace {

bool small(const body::BodyInput& input) { return input.kinematics == base::Kinematics::small; }

/// Each step once and without wear, from corner to corner of its histories unless a body is nonlinear or turns and may need
/// the increments asked for.
Problem trial_of(const Problem& problem) {
  Problem trial = problem;
  bool stepwise = false;
  for (int b = 0; b < trial.body_count(); ++b)
    stepwise = stepwise || (!trial.rigid[b] && (is_nonlinear(trial.inputs[b]) || body::pivot_of(trial.shapes[b]->mesh, trial.inputs[b])));
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

bool turns(const solver::System& system, int b) {
  const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
  return linear && linear->turning();
}

void take_finite(body::BodyInput& input) {
  input.kinematics = base::Kinematics::finite;
  if (const auto* linear = std::get_if<material::LinearElastic>(&input.material))
    input.material = material::Hencky{linear->E_MPa, linear->nu};
}

}  // namespace

fem::Distortion distortion_of(const Problem& problem, const State& state, const solver::System& system, int b) {
  return fem::distortion(state.shapes[b]->mesh, problem.scene.analysis, recovered_in_frame(problem, state, system, b));
}

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
        keep_largest(*choices[b], fem::distortion(*body.mesh, trial.scene.analysis, fem::in_frame(body.mesh->X, body.u, body.angle_rad)));
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
    if (problem.kinematics[b] && small(problem.inputs[b]))
      largest = std::max(largest.value_or(0.0), distortion_of(problem, state, system, b).error());
  return largest;
}

std::string check_small_strain(const Problem& problem, State& state, const solver::System& system, const Observer& observer) {
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto& input = problem.inputs[b];
    if (problem.rigid[b] || problem.kinematics[b] || !small(input)) continue;
    const double strain = distortion_of(problem, state, system, b).strain_and_rotation();
    if (strain <= strain_warned_of) continue;
    constexpr double crushed = 0.3;
    char text[300];
    std::snprintf(text, sizeof text, "%s %.2g %% where body %s stores its energy: small strain gets that wrong by about %.2g %%; write "
                  "kinematics = \"finite\"%s", turns(system, b) ? "strain reaches" : "strain and rotation reach", 100.0 * strain,
                  input.name.c_str(), 200.0 * strain, strain > crushed ? ", and check loads, motions and E_MPa" : "");
    const auto found = problem.scene.body_material.find(input.name);
    const bool asked = found != problem.scene.body_material.end() && found->second.kinematics_given;
    if (strain > strain_refused && !asked) return scene_line(problem.scene, "body " + input.name) + text;
    warn(state, observer, {"strain", "body " + input.name, text, strain});
  }
  return {};
}

}  // namespace reye::sim
