#include "sim/study/accuracy.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "sim/march/march.hpp"
#include "sim/problem/timer.hpp"
#include "sim/study/decide.hpp"
#include "sim/study/discretisation.hpp"

namespace reye::sim {

namespace {

/// Elements per half width of a fine zone: of the first and the last pilot, and the most that are chosen.
constexpr double first_elements = 16.0, last_elements = 128.0, most_elements = 400.0;
constexpr double pilot_reach =
    4.0;  ///< times the elements of a pilot, up to which the order of its error is extrapolated
/// The share of the accuracy that the error of the mesh may take by the estimate: the cycle jump has half of it, and
/// the true error may be 1.8 times as large as the estimate (`results/mesh_error`).
constexpr double share = 0.4;

bool sized(const cad::FineZone& zone) { return zone.size_mm > 0.0; }

/// The scene with so many elements per half width of each zone that names no size.
scene::Scene with_elements(scene::Scene scene, double elements) {
  for (auto& zone : scene.geometry.fine_zones)
    if (!sized(zone)) zone.size_mm = zone.half_width_mm / elements;
  return scene;
}

/// Plays a scene and its companion without output.
DiscretisationError played(scene::Scene scene) {
  scene.output = {};
  Cache cache;
  const Problem problem = decide(scene, cache);
  const auto as_it_came = [](const body::ShapePtr& shape) { return shape->drawing->part.mesh.has_value(); };
  if (std::all_of(problem.shapes.begin(), problem.shapes.end(), as_it_came))
    return {RunStatus::failed, "the meshes came with their files as they are", {}, {}, {}, 0.0};
  State state = initial_state(problem);
  const Summary summary = march(problem, state, {}, cache);
  if (summary.status != RunStatus::done) return {summary.status, summary.reason, {}, {}, {}, 0.0};
  return mesh_error(problem, state, cache, {});
}

[[noreturn]] void refuse(const scene::Scene& scene, const std::string& rule) {
  throw base::InputError(
      {{"accuracy", base::formatted("%g", scene.accuracy), rule + "; give the fine zones their size_mm"}});
}

struct Pilot {
  double elements = 0.0;
  DiscretisationError error;
  double suited = 0.0;  ///< elements that the accuracy asks for by this error
};

/// Whether the elements that a pilot asks for are near enough to its own, or too many in any case.
bool reaches(const Pilot& pilot) {
  const bool hopeless = pilot.suited > 2.0 * most_elements;
  return pilot.elements > 0.0 && (hopeless || pilot.suited <= pilot_reach * pilot.elements);
}

/// The coarsest pilot whose extrapolation reaches the elements it asks for, or the finest that gives an error.
Pilot piloted(const scene::Scene& scene) {
  Pilot best;
  std::string reason;
  for (double n = first_elements; n <= last_elements && !reaches(best); n *= 2.0) {
    const DiscretisationError error = played(with_elements(scene, n));
    reason = error.reason;
    if (!error.surface) continue;
    const double finer = std::pow(*error.surface / (share * scene.accuracy), 1.0 / error.order);
    best = {n, error, n * std::max(1.0, finer)};
  }
  if (best.elements > 0.0) return best;
  refuse(scene, base::formatted("a pilot run on %g elements per half width of the fine zones gives no error estimate: ",
                                last_elements) +
                    reason);
}

/// The sizes chosen, as a scene would give them.
std::string sizes(const scene::Scene& asked, const scene::Scene& chosen) {
  std::string list;
  for (std::size_t z = 0; z < asked.geometry.fine_zones.size(); ++z)
    if (const auto& zone = chosen.geometry.fine_zones[z]; !sized(asked.geometry.fine_zones[z]))
      list += (list.empty() ? "" : ", ") + zone.contact +
              base::formatted(" %.3g mm round (%.4g, %.4g)", zone.size_mm, zone.centre_mm.x() + 0.0,
                              zone.centre_mm.y() + 0.0);
  return list;
}

}  // namespace

std::vector<std::string> choose_sizes(scene::Scene& scene, Cache& cache) {
  const auto& zones = scene.geometry.fine_zones;
  if (std::all_of(zones.begin(), zones.end(), sized)) return {};
  Timer timer(cache, "pilot");
  const double start = cpu_seconds();
  const Pilot pilot = piloted(scene);
  const scene::Scene chosen = with_elements(scene, pilot.suited);
  const auto told = base::formatted(
                        "with %g elements per half width of the fine zones the estimated error is %.2g %% and falls "
                        "with size^%g; ",
                        pilot.elements, 100.0 * *pilot.error.surface, pilot.error.order) +
                    base::formatted("%.0f elements suit the accuracy: ", pilot.suited) + sizes(scene, chosen);
  if (pilot.suited > most_elements)
    refuse(scene, told + base::formatted("; more than %g are not chosen", most_elements));
  scene = chosen;
  const double seconds = cpu_seconds() - start;
  cache.cpu_s += seconds;
  return {base::formatted("accuracy %g %%: ", 100.0 * scene.accuracy) + told,
          base::formatted("    the pilot run took %.2g s of processor time; it is repeated at each restart", seconds)};
}

}  // namespace reye::sim
