#pragma once
#include "scene/solid/solid_scene.hpp"
#include "sim/solid/solid_player.hpp"
#include "sim/solid/solid_redraw.hpp"
#include "support/solid_worn.hpp"

/// A worn ball on its flat, remeshed without wear.
namespace reye::support {

/// Mean pressures of the contact in rings of equal width about the origin, up to a radius.
inline std::vector<double> ring_pressures(const solver::SolidSystem& system, const solver::SolidSolution& solved,
                                          double radius, int rings) {
  std::vector<double> force(rings, 0.0), area(rings, 0.0);
  const auto& points = system.contacts[0].secondary.skin.x;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double r = points[j].head<2>().norm();
    if (r >= radius) continue;
    const auto k = static_cast<std::size_t>(rings * r / radius);
    const double covered = solved.place[0].covered[static_cast<Eigen::Index>(j)];
    force[k] += covered * contact::pressure(solved.nodes[0][j], solved.place[0].frame[j]);
    area[k] += covered;
  }
  for (int k = 0; k < rings; ++k) force[k] /= std::max(area[k], 1e-300);
  return force;
}

struct RemeshedCap {
  double volume_error = 0.0;  ///< largest change of a body's volume, of its own
  double force_error = 0.0;   ///< largest change of the normal force, of its own
  double shear_error = 0.0;   ///< and of the tangential force
  std::vector<double> jumps;  ///< per remesh: change of the pressures of rings, root of the mean square over the mean
  double drift = 0.0;         ///< that change between the first and the last mesh
};

/// geo/ball_worn_flat_solid over some of its cycles, with a fine zone for these.
inline scene::SolidScene ball_worn_for(double cycles, double zone_mm) {
  auto scene = scene::read_solid(std::string(REYE_SOURCE_DIR) + "/geo/ball_worn_flat_solid/scene.toml");
  for (auto& zone : scene.geometry.fine_zones) zone.radius_mm = zone_mm;
  scene.steps.back().cycles = cycles;
  return scene;
}

/// Remeshes both bodies so many times. With friction the sliding drags the ball, cut open in the plane across it.
inline RemeshedCap remeshed_cap(int times, double friction = 0.0) {
  auto scene = ball_worn_for(60.0, 0.9);
  if (friction > 0.0) {
    scene.contacts.front().friction = friction;
    std::erase(scene.symmetry, "ball_sx");
    std::erase(scene.symmetry, "plate_sx");
    std::erase_if(scene.supports, [](const auto& s) { return s.face == "ball_sx" || s.face == "plate_sx"; });
    for (auto& support : scene.supports)
      if (support.face == "base") support.along[0] = fixed_motion();
  }
  const auto problem = sim::prepare_solid(std::move(scene));
  constexpr double force = 5.0, R = 5.0, cycles_mm = 60e3, alpha = 3e-8;
  const double radius = std::pow(4.0 * R * alpha * 4.0 * force * cycles_mm / std::numbers::pi, 0.25);
  std::optional<sim::SolidRunState> last;
  sim::SolidObserver observer;
  observer.state = [&](const sim::SolidRunState& state) { last = state; };
  const auto summary = sim::run_solid(problem, observer);
  if (summary.status != sim::RunStatus::done) throw std::runtime_error(summary.reason);
  auto& state = *last;
  sim::SolidPlayer player(problem, state, {});
  const auto& step = problem.scene.steps.back();
  constexpr int rings = 8;
  if (const auto why = player.settle(state, step); !why.empty()) throw std::runtime_error(why);
  const auto of_now = [&] { return ring_pressures(player.system(), *state.solved, 0.9 * radius, rings); };
  const double mean = 4.0 * force / (std::numbers::pi * radius * radius);
  const auto difference = [&](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (int k = 0; k < rings; ++k) sum += std::pow(a[k] - b[k], 2);
    return std::sqrt(sum / rings) / mean;
  };
  std::vector<double> volumes;
  for (const auto& mesh : state.meshes) volumes.push_back(mesh::volume(*mesh));
  RemeshedCap result;
  const auto first = of_now();
  auto before = first;
  const auto shear = [&] { return sim::contact_row(player.system(), state, 0).tangential_force_N; };
  const double first_shear = shear();
  for (int k = 0; k < times; ++k) {
    const auto why = sim::redraw_bodies(problem, player, {state.meshes, {"again", "again"}}, step, {}, state);
    if (!why.empty()) throw std::runtime_error(why);
    const auto now = of_now();
    result.jumps.push_back(difference(now, before));
    before = now;
    double pressed = 0.0;
    for (std::size_t j = 0; j < state.solved->nodes[0].size(); ++j)
      pressed += state.solved->place[0].covered[static_cast<Eigen::Index>(j)] *
                 contact::pressure(state.solved->nodes[0][j], state.solved->place[0].frame[j]);
    result.force_error = std::max(result.force_error, std::abs(pressed / force - 1.0));
    if (friction > 0.0) result.shear_error = std::max(result.shear_error, std::abs(shear() / first_shear - 1.0));
    for (std::size_t b = 0; b < volumes.size(); ++b)
      result.volume_error = std::max(result.volume_error, std::abs(mesh::volume(*state.meshes[b]) / volumes[b] - 1.0));
  }
  result.drift = difference(before, first);
  return result;
}

}  // namespace reye::support
