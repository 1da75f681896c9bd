#include "fem/distortion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fem/element.hpp"

namespace reye::fem {

namespace {

/// Contribution of one Gauss point to the means.
struct Share {
  double strain = 0.0, rotation = 0.0, weight = 0.0;
};

Share share_of(const Mesh& mesh, int cell, Analysis analysis, const base::Points& u, const RulePoint& point) {
  const auto& [at, N, dN_dxi] = point;
  Eigen::Matrix2d J = Eigen::Matrix2d::Zero(), du_dxi = Eigen::Matrix2d::Zero();
  double R = 0.0, u_R = 0.0;
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) {
    const int node = mesh.cells[cell][a];
    J += mesh.X[node] * dN_dxi.row(a);
    du_dxi += u[node] * dN_dxi.row(a);
    R += N[a] * mesh.X[node].x();
    u_R += N[a] * u[node].x();
  }
  const Eigen::Matrix2d H = du_dxi * J.inverse();
  const double hoop = analysis == Analysis::axisymmetric ? u_R / R : 0.0;
  const double mean = 0.5 * (H(0, 0) + H(1, 1));
  const double stretch = 0.5 * (H(0, 0) - H(1, 1)), shear = 0.5 * (H(0, 1) + H(1, 0));
  const double radius = std::sqrt(stretch * stretch + shear * shear);
  const double volume = at.weight * J.determinant() * base::out_of_plane(analysis, R);
  return {std::max(std::abs(mean) + radius, std::abs(hoop)), 0.5 * std::abs(H(1, 0) - H(0, 1)),
          volume * (2.0 * mean * mean + 2.0 * radius * radius + hoop * hoop)};
}

}  // namespace

Distortion distortion(const Mesh& mesh, Analysis analysis, const base::Points& u) {
  Distortion sum;
  double weight = 0.0;
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    for (const RulePoint& point : tabulated_rule(mesh.kind)) {
      const Share share = share_of(mesh, cell, analysis, u, point);
      sum.strain += share.weight * share.strain;
      sum.rotation += share.weight * share.rotation;
      weight += share.weight;
    }
  return weight > 0.0 ? Distortion{sum.strain / weight, sum.rotation / weight} : Distortion{};
}

}  // namespace reye::fem
