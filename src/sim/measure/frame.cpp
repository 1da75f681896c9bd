#include "sim/measure/frame.hpp"

#include <algorithm>

#include "fem/finite.hpp"
#include "fem/frame.hpp"
#include "fem/stiffness.hpp"
#include "sim/measure/displacements.hpp"
#include "sim/measure/nodal_depth.hpp"
#include "sim/measure/overlap.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/surfaces.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/timer.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

/// Stress of a body at its nodes, and accumulated plastic strain where it has any.
void paint_material(const body::BodyInput& input, const body::Interior& interior, bool rigid, BodyFrame& body) {
  if (rigid) return;
  if (!is_nonlinear(input)) {
    const auto w = fem::in_frame(body.mesh->X, body.u, body.angle_rad);
    body.stress_MPa = fem::nodal_stress(*body.mesh, input.material, input.analysis, input.b_bar, w);
    if (body.angle_rad != 0.0)
      for (auto& stress : body.stress_MPa) stress = fem::turned(stress, body.angle_rad);
    return;
  }
  Vector u(2 * static_cast<Eigen::Index>(body.u.size()));
  for (std::size_t i = 0; i < body.u.size(); ++i) u.segment<2>(2 * static_cast<Eigen::Index>(i)) = body.u[i];
  const fem::Solid solid{input.material, input.analysis, input.kinematics, input.b_bar};
  auto nodal = fem::nodal_state(*body.mesh, solid, u, {interior.history, interior.F0});
  body.stress_MPa = std::move(nodal.stress);
  if (solid.has_history()) body.plastic_strain = std::move(nodal.plastic_strain);
}

/// Shows depths of wear at the nodes of a side, where it is the deepest.
void paint_wear(const std::vector<contact::SurfaceNode>& nodes, const std::vector<double>& depth, Frame& frame) {
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    double& shown = frame.bodies[nodes[k].body].wear_depth_mm[nodes[k].mesh_node];
    shown = std::max(shown, depth[k]);
  }
}

/// Displacements and stress inside the bodies, and their wear.
void paint_bodies(const Problem& problem, const State& state, const solver::System& system, Frame& frame) {
  const auto controls = controls_at(problem, system, state.factors, scene::Step(), 0.0, 0.0, 1.0);
  for (int b = 0; b < problem.body_count(); ++b) {
    BodyFrame& body = frame.bodies[b];
    const Vector q = system.part(state.solution.q.high, b);
    body.u = displacements(system.bodies[b], q, state.solution.interiors[b], controls.load_factors[b]);
    body.angle_rad = turned_by(system.bodies[b], q);
    paint_material(problem.inputs[b], state.solution.interiors[b], problem.rigid[b], body);
    body.wear_depth_mm.assign(body.u.size(), 0.0);
  }
  const auto shown = as_shown(problem, state);
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    paint_wear(setup.secondary_nodes, depths(setup.secondary, shown[c].removed_secondary), frame);
    paint_wear(setup.primary_nodes, depths(setup.primary, shown[c].removed_primary), frame);
  }
}

/// Adds the displacements before a reference was renewed, so that they count from the start, at the nodes' first
/// places.
void count_from_start(const State& state, Frame& frame) {
  for (std::size_t b = 0; b < state.displaced.size(); ++b) {
    const auto& before = state.displaced[b];
    auto& body = frame.bodies[b];
    if (before.empty() || body.u.empty()) continue;
    auto mesh = std::make_shared<mesh::Mesh>(*body.mesh);
    for (std::size_t i = 0; i < before.size(); ++i) {
      mesh->X[i] -= before[i];
      body.u[i] += before[i];
    }
    body.mesh = std::move(mesh);
  }
}

BodyFrame body_frame(const std::string& name, const body::ShapePtr& shape) {
  BodyFrame body;
  body.name = name;
  body.mesh = std::shared_ptr<const mesh::Mesh>(shape, &shape->mesh);
  return body;
}

/// The tables of the sides of contacts and bonds.
void add_surfaces(const Problem& problem, const State& state, const solver::System& system, Frame& frame) {
  const auto shown = as_shown(problem, state);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    for (auto& surface : surface_records(system.contacts[c], shown[c], state.shapes, problem.contacts[c]))
      frame.surfaces.push_back(std::move(surface));
  for (std::size_t b = 0; b < problem.bonds.size(); ++b) {
    const auto c = problem.contacts.size() + b;
    frame.bonds.push_back(
        surface_records(system.contacts[c], state.solution.contacts[c], state.shapes, problem.bonds[b]).front());
  }
}

}  // namespace

Frame make_frame(const Problem& problem, const State& state, Cache& cache, const std::string& step) {
  const auto kept = timed_system(problem, state, cache);
  const auto& system = *kept;
  Timer timer(cache, "frames");
  Frame frame;
  frame.cycle = state.cycle;
  frame.step = step;
  for (int b = 0; b < problem.body_count(); ++b)
    frame.bodies.push_back(body_frame(problem.inputs[b].name, state.shapes[b]));
  const auto& output = problem.scene.output;
  if (output.frames.paraview || !output.probes.empty()) paint_bodies(problem, state, system, frame);
  count_from_start(state, frame);
  add_surfaces(problem, state, system, frame);
  return frame;
}

namespace {

/// Warns of bodies inside one another, where there are several.
void watch_overlaps(const Problem& problem, State& state, Cache& cache, const Observer& observer, const Frame& frame) {
  if (problem.body_count() < 2) return;
  std::vector<std::vector<Vec2>> u;
  const auto kept = timed_system(problem, state, cache);
  const auto& system = *kept;
  Timer timer(cache, "frames");
  const auto controls = controls_at(problem, system, state.factors, {}, 0.0, 0.0, 1.0);
  for (int b = 0; b < problem.body_count(); ++b)
    u.push_back(!frame.bodies[b].u.empty() ? frame.bodies[b].u
                                           : displacements(system.bodies[b], system.part(state.solution.q.high, b),
                                                           state.solution.interiors[b], controls.load_factors[b]));
  for (auto& warning : overlap_warnings(problem, state.shapes, u)) warn(state, observer, std::move(warning));
}

}  // namespace

void show_frame(const Problem& problem, State& state, Cache& cache, const Observer& observer, const std::string& step) {
  if (!observer.frame || state.shown) return;
  const Frame frame = make_frame(problem, state, cache, step);
  observer.frame(frame);
  state.shown = true;
  watch_overlaps(problem, state, cache, observer, frame);
}

}  // namespace reye::sim
