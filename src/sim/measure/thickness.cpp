#include "sim/measure/thickness.hpp"

#include "mesh/measure.hpp"
#include "sim/measure/displacements.hpp"

namespace reye::sim {

namespace {

/// Per mesh node of a body: volume now over volume on X of the cells that meet there.
std::vector<double> volume_ratio(const mesh::Mesh& mesh, const base::Points& x, base::Analysis analysis) {
  std::vector<double> now(mesh.X.size(), 0.0), before(mesh.X.size(), 0.0);
  const int corners = mesh::corners(mesh.kind);
  for (const auto& cell : mesh.cells) {
    double r = 0.0, R = 0.0;
    for (int a = 0; a < corners; ++a) {
      r += x[cell[a]].x() / corners;
      R += mesh.X[cell[a]].x() / corners;
    }
    const double v = mesh::cell_area(x, mesh.kind, cell) * base::out_of_plane(analysis, r);
    const double V = mesh::cell_area(mesh.X, mesh.kind, cell) * base::out_of_plane(analysis, R);
    for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) {
      now[cell[a]] += v;
      before[cell[a]] += V;
    }
  }
  for (std::size_t i = 0; i < now.size(); ++i) now[i] /= before[i];
  return now;
}

/// Thickness at the nodes of one boundary, in the order of mesh::nodes_of.
std::vector<double> of_boundary(const Problem& problem, const State& state, const solver::System& system,
                                const contact::BoundaryRef& ref) {
  const auto& mesh = state.shapes[ref.body]->mesh;
  const auto nodes = mesh::nodes_of(mesh.boundaries.at(ref.boundary));
  if (problem.rigid[ref.body] || problem.inputs[ref.body].kinematics == base::Kinematics::small)
    return std::vector<double>(nodes.size(), 1.0);
  base::Points x = displacements(system.bodies[ref.body], system.part(state.solution.q.high, ref.body),
                                 state.solution.interiors[ref.body], {});
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += mesh.X[i];
  const auto J = volume_ratio(mesh, x, problem.scene.analysis);
  std::vector<int> order;
  const auto area_of = [&](const base::Points& points) {
    return mortar::make_surface(points, mesh.boundaries.at(ref.boundary), problem.scene.analysis, order,
                                mesh::order(mesh.kind))
        .area;
  };
  const auto now = area_of(x), before = area_of(mesh.X);
  std::vector<double> thickness;
  for (std::size_t k = 0; k < nodes.size(); ++k) thickness.push_back(J[nodes[k]] * before[k] / now[k]);
  return thickness;
}

}  // namespace

LayerThickness layer_thickness(const Problem& problem, const State& state, const solver::System& system, int contact) {
  const auto& placed = problem.contacts[contact];
  const auto finite = [&](const contact::BoundaryRef& ref) {
    return !problem.rigid[ref.body] && problem.inputs[ref.body].kinematics == base::Kinematics::finite;
  };
  LayerThickness result;
  if (finite(placed.secondary)) result.secondary = of_boundary(problem, state, system, placed.secondary);
  bool any = false;
  for (const auto& ref : placed.primary) any = any || finite(ref);
  if (!any) return result;
  for (const auto& ref : placed.primary) {
    const auto part = of_boundary(problem, state, system, ref);
    result.primary.insert(result.primary.end(), part.begin(), part.end());
  }
  return result;
}

}  // namespace reye::sim
