#include "body/resultant.hpp"

#include <numbers>

#include "fem/assemble_loads.hpp"

namespace reye::body {

using base::Vec2;
using mesh::Mesh;

namespace {

Resultant of_nodal(const Mesh& mesh, const base::Vector& f, const Vec2& centre) {
  Resultant r;
  for (int node = 0; node < mesh.node_count(); ++node) {
    const Vec2 force = f.segment<2>(2 * node);
    r.force += force;
    r.spread += force * (mesh.X[node] - centre).transpose();
  }
  return r;
}

}  // namespace

Resultant resultant(const Mesh& mesh, base::Analysis analysis, const fem::BoundaryLoad& load, const Vec2& centre) {
  return of_nodal(mesh, fem::load_vector(mesh, analysis, load), centre);
}

Resultant resultant(const Mesh& mesh, base::Analysis analysis, const fem::PointLoad& load, const Vec2& centre) {
  return of_nodal(mesh, fem::load_vector(mesh, analysis, load), centre);
}

Resultant resultant(const Mesh& mesh, base::Analysis analysis, const fem::BodyForce& load, const Vec2& centre) {
  if (!mesh.cells.empty()) return of_nodal(mesh, fem::load_vector(mesh, analysis, load), centre);
  double area = 0.0;
  Vec2 first{0.0, 0.0};  // int (X - c) dA, by Green's theorem over the facets of the outline
  for (const auto& loop : mesh.outline)
    for (size_t k = 0; k + 1 < loop.size(); ++k) {
      const Vec2 a = mesh.X[loop[k]] - centre, b = mesh.X[loop[k + 1]] - centre;
      area += 0.5 * base::cross(a, b);
      first += base::cross(a, b) * (a + b) / 6.0;
    }
  if (analysis == base::Analysis::axisymmetric)
    return {2.0 * std::numbers::pi * (first.x() + centre.x() * area) * load.force_N_per_mm3, Eigen::Matrix2d::Zero()};
  return {area * load.force_N_per_mm3, load.force_N_per_mm3 * first.transpose()};
}

Vec2 box_centre(const Mesh& mesh) {
  Vec2 low = mesh.X.front(), high = low;
  for (const Vec2& X : mesh.X) {
    low = low.cwiseMin(X);
    high = high.cwiseMax(X);
  }
  return 0.5 * (low + high);
}

}  // namespace reye::body
