#include "fem/assemble_loads.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "fem/element.hpp"
#include "fem/loaded_edges.hpp"
#include "fem/places.hpp"

namespace reye::fem {

using base::Vector;

namespace {

Vector zero(const Mesh& mesh) { return Vector::Zero(2 * static_cast<Eigen::Index>(mesh.X.size())); }

}  // namespace

Vector load_vector(const Mesh& mesh, Analysis analysis, const BoundaryLoad& load) {
  Vector f = zero(mesh);
  for (const LoadedEdge& edge : loaded_edges(mesh, load))
    for (const EdgePoint& point : edge_points(edge)) {
      const OnEdge here = on_edge(edge, point, [&](int node) { return mesh.X[node]; });
      const Vec2 t_ds = load.traction_MPa * here.tangent.norm() - load.pressure_MPa * base::right_of(here.tangent);
      const double weight = point.weight * base::out_of_plane(analysis, here.x.x());
      for (int a = 0; a < edge.count; ++a) f.segment<2>(2 * edge.nodes[a]) += point.N[a] * weight * t_ds;
    }
  return f;
}

Vector load_vector(const Mesh& mesh, Analysis, const PointLoad& load) {
  Vector f = zero(mesh);
  f.segment<2>(2 * nearest_node(mesh, load.point_mm)) = load.force_N_per_mm;
  return f;
}

Vector load_vector(const Mesh& mesh, Analysis analysis, const BodyForce& load) {
  Vector f = zero(mesh);
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    for (const VolumePoint& p : volume_points(mesh, cell, analysis))
      for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a)
        f.segment<2>(2 * mesh.cells[cell][a]) += p.N[a] * p.volume * load.force_N_per_mm3;
  return f;
}

}  // namespace reye::fem
