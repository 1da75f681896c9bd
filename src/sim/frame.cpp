#include <algorithm>

#include "fem/stiffness.hpp"
#include "sim/block.hpp"
#include "sim/measure.hpp"
#include "sim/timer.hpp"

namespace reye::sim {

Frame make_frame(const Problem& problem, const State& state, Cache& cache, const std::string& step) {
  const auto& system = timed_system(problem, state, cache);
  Timer timer(cache, "frames");
  Frame frame;
  frame.cycle = state.cycle;
  frame.step = step;
  const scene::Step none;
  const auto controls = controls_at(problem, system, state.factors, none, 0.0, 0.0, 1.0);
  for (int b = 0; b < problem.body_count(); ++b) {
    BodyFrame body;
    body.name = problem.inputs[b].name;
    body.mesh = std::shared_ptr<const mesh::Mesh>(state.shapes[b], &state.shapes[b]->mesh);
    const Vector q = system.part(state.solution.q, b);
    body.u = std::visit([&](const auto& o) { return o.recover(q, controls.load_factors[b]); }, system.bodies[b]);
    if (!problem.rigid[b])
      body.stress_MPa = fem::nodal_stress(*body.mesh, problem.inputs[b].material, problem.scene.analysis, problem.inputs[b].b_bar, body.u);
    body.wear_depth_mm.assign(body.u.size(), 0.0);
    frame.bodies.push_back(std::move(body));
  }
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& contact = state.solution.contacts[c];
    for (auto& surface : surface_records(setup, contact, state.shapes, problem.contacts[c])) frame.surfaces.push_back(std::move(surface));
    const auto paint = [&](const std::vector<contact::SurfaceNode>& nodes, const std::vector<double>& depth) {
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        double& shown = frame.bodies[nodes[k].body].wear_depth_mm[nodes[k].mesh_node];
        shown = std::max(shown, depth[k]);
      }
    };
    paint(setup.secondary_nodes, depths(setup.secondary, contact.removed_secondary));
    paint(setup.primary_nodes, depths(setup.primary, contact.removed_primary));
  }
  return frame;
}

}  // namespace reye::sim
