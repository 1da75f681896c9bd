#include "fem/solid/solid_loads.hpp"

#include <Eigen/LU>

#include "mesh/solid/solid_measure.hpp"

namespace reye::fem {

base::Vector face_load(const mesh::SolidMesh& mesh, const std::vector<mesh::Facet>& facets, double pressure_MPa,
                       const Vec3& traction_MPa) {
  base::Vector f = base::Vector::Zero(3 * mesh.node_count());
  for (const auto& facet : facets)
    for (const auto& [xi, weight] : mesh::area_rule(facet.kind)) {
      const auto N = mesh::shape_functions(facet.kind, xi);
      const Vec3 n = weight * mesh::normal_at(mesh.X, facet, xi);
      const Vec3 force = n.norm() * traction_MPa - pressure_MPa * n;
      for (int a = 0; a < facet.count(); ++a) f.segment<3>(3 * facet.nodes[a]) += N[a] * force;
    }
  return f;
}

base::Vector face_force(const mesh::SolidMesh& mesh, const std::vector<mesh::Facet>& facets, const Vec3& force_N) {
  return face_load(mesh, facets, 0.0, force_N / mesh::area(mesh.X, facets));
}

base::Vector body_load(const mesh::SolidMesh& mesh, const Vec3& force_N_per_mm3) {
  base::Vector f = base::Vector::Zero(3 * mesh.node_count());
  for (const auto& cell : mesh.cells) {
    const auto x = mesh::corners_of(mesh.X, mesh.kind, cell);
    for (const auto& [xi, weight] : mesh::volume_rule(mesh.kind)) {
      const double volume = weight * base::Mat3(x.lazyProduct(mesh::shape_gradients(mesh.kind, xi))).determinant();
      const auto N = mesh::shape_functions(mesh.kind, xi);
      for (int a = 0; a < mesh::solid_nodes(mesh.kind); ++a)
        f.segment<3>(3 * cell[a]) += volume * N[a] * force_N_per_mm3;
    }
  }
  return f;
}

}  // namespace reye::fem
