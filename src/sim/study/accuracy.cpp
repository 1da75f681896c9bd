#include "sim/study/accuracy.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "sim/march/march.hpp"
#include "sim/problem/timer.hpp"
#include "sim/study/decide.hpp"
#include "sim/study/discretisation.hpp"
#include "sim/study/pilot.hpp"

namespace reye::sim {

namespace {

constexpr PilotRule plane_rule{16.0, 128.0, 400.0, "half width"};

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
  const Pilot pilot =
      piloted(plane_rule, scene.accuracy, [&](double elements) { return played(with_elements(scene, elements)); });
  const scene::Scene chosen = with_elements(scene, pilot.suited);
  const double seconds = cpu_seconds() - start;
  auto lines = decided(plane_rule, scene.accuracy, pilot, sizes(scene, chosen), seconds);
  scene = chosen;
  cache.cpu_s += seconds;
  return lines;
}

}  // namespace reye::sim
