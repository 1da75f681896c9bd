#include "adapt/transfer/gauss_points.hpp"

#include <Eigen/LU>

#include "fem/element.hpp"

namespace reye::adapt {

GaussPoints gauss_points(const mesh::Mesh& mesh, base::Analysis analysis) {
  const auto rule = fem::stiffness_rule(mesh.kind);
  GaussPoints points{static_cast<int>(rule.size()), {}, {}};
  for (const auto& cell : mesh.cells)
    for (const auto& at : rule) {
      const auto N = fem::shape_functions(mesh.kind, at.xi);
      const auto dN_dxi = fem::shape_gradients(mesh.kind, at.xi);
      base::Vec2 x = base::Vec2::Zero();
      Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
      for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) {
        x += N[a] * mesh.X[cell[a]];
        J += dN_dxi.row(a).transpose() * mesh.X[cell[a]].transpose();
      }
      points.x.push_back(x);
      points.volume.push_back(at.weight * J.determinant() * base::out_of_plane(analysis, x.x()));
    }
  return points;
}

}  // namespace reye::adapt
