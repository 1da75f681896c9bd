#include "sim/measure/small_strain.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "sim/measure/displacements.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

bool small(const body::BodyInput& input) { return input.kinematics == base::Kinematics::small; }

bool turns(const solver::System& system, int b) {
  const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
  return linear && linear->turning();
}

}  // namespace

fem::Distortion distortion_of(const Problem& problem, const State& state, const solver::System& system, int b) {
  return fem::distortion(state.shapes[b]->mesh, problem.scene.analysis, recovered_in_frame(problem, state, system, b));
}

std::optional<double> small_strain_error(const Problem& problem, const State& state, const solver::System& system) {
  std::optional<double> largest;
  for (int b = 0; b < problem.body_count(); ++b)
    if (problem.kinematics[b] && small(problem.inputs[b]))
      largest = std::max(largest.value_or(0.0), distortion_of(problem, state, system, b).error());
  return largest;
}

std::string check_small_strain(const Problem& problem, State& state, const solver::System& system,
                               const Observer& observer) {
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto& input = problem.inputs[b];
    if (problem.rigid[b] || problem.kinematics[b] || !small(input)) continue;
    const double strain = distortion_of(problem, state, system, b).strain_and_rotation();
    if (strain <= strain_warned_of) continue;
    constexpr double crushed = 0.3;
    const std::string text = base::formatted(
        "%s %.2g %% where body %s stores its energy: the error of small strain in that is about %.2g %%; write "
        "kinematics = \"finite\"%s",
        turns(system, b) ? "strain reaches" : "strain and rotation reach", 100.0 * strain, input.name.c_str(),
        200.0 * strain, strain > crushed ? ", and check loads, motions and E_MPa" : "");
    const auto found = problem.scene.body_material.find(input.name);
    const bool asked = found != problem.scene.body_material.end() && found->second.kinematics_given;
    if (strain > strain_refused && !asked) return scene_line(problem.scene, "body " + input.name) + text;
    warn(state, observer, {"strain", "body " + input.name, text, strain});
  }
  return {};
}

}  // namespace reye::sim
