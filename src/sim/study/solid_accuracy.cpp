#include "sim/study/solid_accuracy.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "scene/solid/solid_located.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/solid_march.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/study/pilot.hpp"
#include "sim/study/solid_discretisation.hpp"

namespace reye::sim {

namespace {

/// Per radius, or least half width, of a zone.
constexpr PilotRule solid_rule{6.0, 24.0, 80.0, "radius"};

bool has_size(const cad::SolidFineZone& zone) { return zone.size_mm > 0.0; }

double extent(const cad::SolidFineZone& zone) {
  return zone.radius_mm > 0.0 ? zone.radius_mm : zone.half_widths_mm.minCoeff();
}

scene::SolidScene with_per_radius(scene::SolidScene scene, double elements) {
  for (auto& zone : scene.geometry.fine_zones)
    if (!has_size(zone)) zone.size_mm = extent(zone) / elements;
  return scene;
}

/// Plays a scene and its companion without output.
DiscretisationError played(scene::SolidScene scene) {
  scene.frames = {};
  scene.frames.paraview = false;
  const SolidProblem problem = prepare_solid(std::move(scene));
  const auto failed = [](std::string reason) {
    DiscretisationError error;
    error.companion = RunStatus::failed;
    error.reason = std::move(reason);
    return error;
  };
  if (const auto plan = solid_plan(problem); !plan.refusal.empty()) return failed(plan.refusal);
  SolidRunState end = initial_solid_state(problem);
  SolidObserver observer;
  observer.state = [&end](const SolidRunState& now) { end = now; };
  const SolidSummary summary = run_solid(problem, end, observer);
  if (summary.status != RunStatus::done) return failed(summary.reason);
  return mesh_error(problem, end, {});
}

/// The sizes chosen, as a scene would give them.
std::string sizes(const scene::SolidScene& asked, const scene::SolidScene& chosen) {
  std::string list;
  for (std::size_t z = 0; z < asked.geometry.fine_zones.size(); ++z)
    if (const auto& zone = chosen.geometry.fine_zones[z]; !has_size(asked.geometry.fine_zones[z]))
      list += (list.empty() ? "" : ", ") + zone.contact +
              base::formatted(" %.3g mm round (%.4g, %.4g, %.4g)", zone.size_mm, zone.centre_mm.x() + 0.0,
                              zone.centre_mm.y() + 0.0, zone.centre_mm.z() + 0.0);
  return list;
}

}  // namespace

std::vector<std::string> choose_sizes(scene::SolidScene& scene) {
  const auto& zones = scene.geometry.fine_zones;
  if (std::all_of(zones.begin(), zones.end(), has_size)) return {};
  const double start = cpu_seconds();
  const Pilot pilot =
      piloted(solid_rule, scene.accuracy, [&](double elements) { return played(with_per_radius(scene, elements)); });
  const auto chosen = with_per_radius(scene, pilot.suited);
  auto lines = decided(solid_rule, scene.accuracy, pilot, sizes(scene, chosen), cpu_seconds() - start);
  scene = chosen;
  return lines;
}

SolidProblem prepare(scene::SolidScene scene, std::optional<cad::SolidGeometry> geometry) {
  std::vector<std::string> lines;
  try {
    lines = choose_sizes(scene);
  } catch (const base::InputError& error) {
    throw scene::located(scene, error.issues());
  }
  SolidProblem problem =
      geometry ? prepare_solid(std::move(scene), std::move(*geometry)) : prepare_solid(std::move(scene));
  problem.decided = std::move(lines);
  return problem;
}

}  // namespace reye::sim
