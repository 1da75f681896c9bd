#include "sim/study/solid_accuracy.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "scene/solid/solid_located.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/solid_march.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/study/solid_discretisation.hpp"

namespace reye::sim {

namespace {

/// Elements per radius, or least half width, of a fine zone: of the first and the last pilot, and the most chosen.
constexpr double first_per_radius = 6.0, last_per_radius = 24.0, most_per_radius = 80.0;
constexpr double reach_of_pilot = 4.0;  ///< times its elements, up to which the order of its error is extrapolated
constexpr double share_of_mesh = 0.4;   ///< of the accuracy, by the estimate; the cycle jump has half of it

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

[[noreturn]] void refuse(const scene::SolidScene& scene, const std::string& rule) {
  throw base::InputError(
      {{"accuracy", base::formatted("%g", scene.accuracy), rule + "; give the fine zones their size_mm"}});
}

struct SolidPilot {
  double elements = 0.0;
  DiscretisationError error;
  double suited = 0.0;  ///< elements that the accuracy asks for by this error
};

/// The coarsest pilot whose extrapolation reaches the elements it asks for, or the finest that gives an error.
SolidPilot piloted(const scene::SolidScene& scene) {
  SolidPilot best;
  std::string reason;
  for (double n = first_per_radius; n <= last_per_radius; n *= 2.0) {
    if (best.elements > 0.0 && (best.suited > 2.0 * most_per_radius || best.suited <= reach_of_pilot * best.elements))
      break;
    const DiscretisationError error = played(with_per_radius(scene, n));
    reason = error.reason;
    if (!error.surface) continue;
    const double finer = std::pow(*error.surface / (share_of_mesh * scene.accuracy), 1.0 / error.order);
    best = {n, error, n * std::max(1.0, finer)};
  }
  if (best.elements > 0.0) return best;
  refuse(scene, base::formatted("a pilot run on %g elements per radius of the fine zones gives no error estimate: ",
                                last_per_radius) +
                    reason);
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
  const SolidPilot pilot = piloted(scene);
  const auto chosen = with_per_radius(scene, pilot.suited);
  const auto told = base::formatted(
                        "with %g elements per radius of the fine zones the estimated error is %.2g %% and falls with "
                        "size^%g; ",
                        pilot.elements, 100.0 * *pilot.error.surface, pilot.error.order) +
                    base::formatted("%.0f elements suit the accuracy: ", pilot.suited) + sizes(scene, chosen);
  if (pilot.suited > most_per_radius)
    refuse(scene, told + base::formatted("; more than %g are not chosen", most_per_radius));
  scene = chosen;
  return {base::formatted("accuracy %g %%: ", 100.0 * scene.accuracy) + told,
          base::formatted("    the pilot run took %.2g s of processor time; it is repeated at each restart",
                          cpu_seconds() - start)};
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
