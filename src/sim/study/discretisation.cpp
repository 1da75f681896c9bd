#include "sim/study/discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"
#include "fem/stiffness.hpp"
#include "mesh/measure.hpp"
#include "sim/march/march.hpp"
#include "sim/measure/correction.hpp"
#include "sim/measure/displacements.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/surfaces.hpp"
#include "sim/problem/timer.hpp"
#include "sim/study/decide.hpp"
#include "sim/study/known_orders.hpp"

namespace reye::sim {

namespace {

constexpr double margin = 3.0;  ///< elements that a zone keeps free at each end

/// Element size away from contacts: that of the scene, or a twentieth of the body's diagonal.
double far_size(const cad::BodyOptions& body, const mesh::Mesh& mesh) {
  if (body.mesh.far_size_mm > 0.0) return body.mesh.far_size_mm;
  const auto box = mesh::bounding_box(mesh.X);
  return std::hypot(box[2] - box[0], box[3] - box[1]) / 20.0;
}

std::vector<SurfaceRecord> surfaces_of(const Problem& problem, const State& state, Cache& cache) {
  const auto kept = system_of(problem, state, cache);
  const auto& system = *kept;
  const auto shown = as_shown(problem, state);
  std::vector<SurfaceRecord> all;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    for (auto& s : surface_records(system.contacts[c], shown[c], state.shapes, problem.contacts[c]))
      all.push_back(std::move(s));
  return all;
}

/// Half the neighbouring lengths of each row, times 2 pi r in axisymmetry.
std::vector<double> shares(const SurfaceRecord& s, base::Analysis analysis) {
  std::vector<double> share(s.arc_length_mm.size(), 0.0);
  for (std::size_t i = 1; i < share.size(); ++i) {
    const double half = 0.5 * (s.arc_length_mm[i] - s.arc_length_mm[i - 1]);
    share[i - 1] += half;
    share[i] += half;
  }
  if (analysis == base::Analysis::axisymmetric)
    for (std::size_t i = 0; i < share.size(); ++i) share[i] *= 2.0 * std::numbers::pi * s.x_mm[i];
  return share;
}

/// A point between two neighbouring rows of a surface.
struct Place {
  std::size_t row = 0;
  double t = 0.0;

  double of(const std::vector<double>& values) const { return values[row] + t * (values[row + 1] - values[row]); }
};

Place nearest(const SurfaceRecord& s, const Vec2& X) {
  Place best;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < s.x_mm.size(); ++i) {
    if (!(s.arc_length_mm[i + 1] > s.arc_length_mm[i])) continue;  // the next chain
    const Vec2 a(s.x_mm[i], s.y_mm[i]), b(s.x_mm[i + 1], s.y_mm[i + 1]);
    const double t = mesh::nearest_parameter(a, b, X);
    if (const double away = (X - a - t * (b - a)).squaredNorm(); away < distance) {
      distance = away;
      best = {i, t};
    }
  }
  return best;
}

double largest_value(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

std::optional<double> wear_difference(const SurfaceRecord& fine, const SurfaceRecord& coarse,
                                      const std::vector<double>& share) {
  double apart = 0.0, worn = 0.0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    const double w = fine.wear_depth_mm[i];
    apart += share[i] * std::abs(w - nearest(coarse, {fine.x_mm[i], fine.y_mm[i]}).of(coarse.wear_depth_mm));
    worn += share[i] * w;
  }
  if (worn <= 0.0) return {};
  const double depth = largest_value(fine.wear_depth_mm);
  return std::max(apart / worn, std::abs(depth - largest_value(coarse.wear_depth_mm)) / depth);
}

std::optional<double> traction_difference(const SurfaceRecord& fine, const SurfaceRecord& coarse,
                                          const std::vector<double>& share) {
  double apart = 0.0, all = 0.0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    const Place place = nearest(coarse, {fine.x_mm[i], fine.y_mm[i]});
    const Vec2 t(fine.pressure_MPa[i], fine.shear_MPa[i]);
    apart += share[i] * (t - Vec2(place.of(coarse.pressure_MPa), place.of(coarse.shear_MPa))).squaredNorm();
    all += share[i] * t.squaredNorm();
  }
  return all > 0.0 ? std::optional(std::sqrt(apart / all)) : std::nullopt;
}

std::optional<double> peak_difference(const SurfaceRecord& fine, const SurfaceRecord& coarse) {
  const double peak = largest_value(fine.pressure_MPa);
  return peak > 0.0 ? std::optional(std::abs(peak - largest_value(coarse.pressure_MPa)) / peak) : std::nullopt;
}

/// Root of the energy of recovered less computed stress over that of the stress, in all linear bodies.
std::optional<double> energy_norm(const Problem& problem, const State& state, Cache& cache) {
  const auto kept = system_of(problem, state, cache);
  const auto& system = *kept;
  fem::StressError sum;
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto& input = problem.inputs[b];
    if (problem.rigid[b] || is_nonlinear(input)) continue;
    const auto error = fem::recovered_error(state.shapes[b]->mesh, input.material, input.analysis, input.b_bar,
                                            recovered_in_frame(problem, state, system, b));
    sum.difference += error.difference;
    sum.energy += error.energy;
  }
  return sum.energy > 0.0 ? std::optional(std::sqrt(sum.difference / sum.energy)) : std::nullopt;
}

bool same_meshes(const Problem& a, const Problem& b) {
  for (int k = 0; k < a.body_count(); ++k)
    if (a.shapes[k]->mesh.node_count() != b.shapes[k]->mesh.node_count()) return false;
  return true;
}

/// Whether some secondary side that touches has fewer elements than an estimate needs (`results/mesh_error`).
bool few_nodes(const std::vector<SurfaceRecord>& surfaces, const State& state) {
  constexpr int fewest = 4;
  for (const auto& s : surfaces) {
    const auto loaded = std::count_if(s.pressure_MPa.begin(), s.pressure_MPa.end(), [](double p) { return p > 0.0; });
    const int wanted = fewest * mesh::order(state.shapes[s.body.front()]->mesh.kind);
    if (s.side == Side::secondary && loaded > 0 && loaded < wanted) return true;
  }
  return false;
}

/// Whether loaded nodes of some secondary side have never slipped while others have: worn profiles have a corner there,
/// which lies anywhere in its element.
bool has_stick_edge(const std::vector<SurfaceRecord>& surfaces) {
  for (const auto& s : surfaces) {
    if (s.side != Side::secondary || s.slip_mm.empty()) continue;
    const double bound = 1e-9 * largest_value(s.slip_mm);
    for (std::size_t i = 0; bound > 0.0 && i < s.slip_mm.size(); ++i)
      if (s.status[i] != 0 && s.slip_mm[i] <= bound) return true;
  }
  return false;
}

/// An observer of progress alone, which may interrupt.
Observer aside(const Observer& outside) {
  Observer o;
  o.interrupted = outside.interrupted;
  if (outside.progress)
    o.progress = [&outside](Progress p) {
      p.step = "coarse: " + p.step;
      outside.progress(p);
    };
  return o;
}

/// Plays the companion run; gives the error of the surface if it ends as the run did.
DiscretisationError compared(const Problem& problem, const State& state, Cache& cache, const Observer& observer) {
  Cache of_coarse;
  const Problem coarse = decide(coarser(problem, state), of_coarse);
  const auto none = [](RunStatus status, std::string reason) {
    DiscretisationError error;
    error.companion = status;
    error.reason = std::move(reason);
    return error;
  };
  if (same_meshes(problem, coarse)) return none(RunStatus::failed, "the meshes came with their files as they are");
  State end = initial_state(coarse);
  const Summary summary = march(coarse, end, aside(observer), of_coarse);
  if (summary.status != RunStatus::done) return none(summary.status, "the companion run: " + summary.reason);
  const auto surfaces = surfaces_of(coarse, end, of_coarse);
  if (few_nodes(surfaces, end))
    return none(RunStatus::done, "fewer than four elements touch where they are twice as long");
  const auto fine = surfaces_of(problem, state, cache);
  const auto apart = mesh_difference(fine, surfaces, problem.scene.analysis);
  if (!apart.wear && !apart.traction) return none(RunStatus::done, "nothing touches at the end");
  DiscretisationError error;
  add_errors(apart, has_stick_edge(fine), error);
  return error;
}

}  // namespace

scene::Scene coarser(const Problem& problem, const State& state) {
  scene::Scene scene = problem.scene;
  for (auto& zone : scene.geometry.fine_zones) {
    zone.half_width_mm += margin * (coarsening - 1.0) * zone.size_mm;
    zone.size_mm *= coarsening;
  }
  for (std::size_t b = 0; b < scene.geometry.bodies.size(); ++b) {
    auto& body = scene.geometry.bodies[b];
    body.mesh.far_size_mm = coarsening * far_size(body, problem.shapes[b]->mesh);
  }
  if (state.step < static_cast<int>(scene.steps.size())) {  // a limit has ended the run
    scene.steps.resize(static_cast<std::size_t>(state.step) + 1);
    if (scene.steps.back().cycles > 0.0) scene.steps.back().cycles = state.step_cycles;
  }
  scene.limits.clear();
  scene.output = {};
  return scene;
}

MeshDifference mesh_difference(const std::vector<SurfaceRecord>& fine, const std::vector<SurfaceRecord>& coarse,
                               base::Analysis analysis) {
  MeshDifference most;
  const auto raise = [](std::optional<double>& to, std::optional<double> value) {
    if (value) to = std::max(to.value_or(0.0), *value);
  };
  for (std::size_t k = 0; k < fine.size(); ++k) {
    const auto share = shares(fine[k], analysis);
    raise(most.wear, wear_difference(fine[k], coarse[k], share));
    if (fine[k].side != Side::secondary) continue;
    raise(most.traction, traction_difference(fine[k], coarse[k], share));
    raise(most.peak, peak_difference(fine[k], coarse[k]));
  }
  return most;
}

DiscretisationError mesh_error(const Problem& problem, const State& state, Cache& cache, const Observer& observer) {
  Timer timer(cache, "error");
  DiscretisationError error;
  try {
    error = compared(problem, state, cache, observer);
  } catch (const std::runtime_error& refusal) {  // the scene or mesh is not valid with longer elements
    error.companion = RunStatus::failed;
    error.reason = refusal.what();
  }
  error.energy_norm = energy_norm(problem, state, cache);
  return error;
}

}  // namespace reye::sim
