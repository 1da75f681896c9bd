#include "fem/solid/solid_stress.hpp"

#include <cmath>

#include "fem/solid/solid_element.hpp"

namespace reye::fem {

namespace {

using Six = Eigen::Matrix<double, 6, 1>;

/// Row g: the polynomial that is 1 at point g and 0 at the others, at the nodes of the cell. It is a shape function of
/// first order in coordinates in which the points are the corners: L = b + (1 - 4 b) M on tetrahedra, sqrt(3) xi.
template <mesh::SolidKind kind>
Eigen::Matrix<double, SolidElement<kind>::points, SolidElement<kind>::nodes> extrapolation() {
  using Element = SolidElement<kind>;
  Eigen::Matrix<double, Element::points, Element::nodes> E;
  const double b = (5.0 - std::sqrt(5.0)) / 20.0;
  for (int a = 0; a < Element::nodes; ++a) {
    const base::Vec3 xi = mesh::reference_node(kind, a);
    if constexpr (kind == mesh::SolidKind::tet4) E(0, a) = 1.0;
    if constexpr (kind == mesh::SolidKind::tet10)
      E.col(a) =
          mesh::shape_functions(mesh::SolidKind::tet4, (xi - base::Vec3::Constant(b)) / (1.0 - 4.0 * b)).head<4>();
    if constexpr (kind == mesh::SolidKind::hex8) E.col(a) = mesh::shape_functions(kind, std::sqrt(3.0) * xi).head<8>();
  }
  return E;
}

/// Calls f(element, cell, gradients, stress at the points) for each cell.
template <class F>
void each_stressed_cell(const mesh::SolidMesh& mesh, const material::Material& material, const base::Points3& u, F f) {
  with_element(mesh.kind, [&]<mesh::SolidKind kind>(const SolidElement<kind>& element) {
    const CellModuli C(material, SolidElement<kind>::b_bar);
    CellGradients<kind> gradients;
    typename SolidElement<kind>::Corners moved;
    for (int cell = 0; cell < mesh.cell_count(); ++cell) {
      set_gradients(element, mesh, cell, gradients);
      for (int a = 0; a < SolidElement<kind>::nodes; ++a) moved.col(a) = u[mesh.cells[cell][a]];
      f(element, cell, gradients, point_stress(gradients, C, moved));
    }
  });
}

/// sigma : C^-1 : sigma = ((1 + nu) sigma : sigma - nu (tr sigma)^2) / E.
double stress_energy(const Six& s, double E, double nu) {
  const double trace = s.head<3>().sum();
  return ((1.0 + nu) * (s.squaredNorm() + s.tail<3>().squaredNorm()) - nu * trace * trace) / E;
}

}  // namespace

std::vector<SolidStress> nodal_stress(const mesh::SolidMesh& mesh, const material::Material& material,
                                      const base::Points3& u) {
  std::vector<SolidStress> sum(mesh.X.size(), SolidStress{});
  std::vector<double> weight(mesh.X.size(), 0.0);
  each_stressed_cell(mesh, material, u,
                     [&]<mesh::SolidKind kind>(const SolidElement<kind>&, int cell,
                                               const CellGradients<kind>& gradients, const auto& at_points) {
                       static const auto E = extrapolation<kind>();
                       const Eigen::Matrix<double, 6, SolidElement<kind>::nodes> values =
                           gradients.sum * at_points.lazyProduct(E);
                       for (int a = 0; a < SolidElement<kind>::nodes; ++a) {
                         const int node = mesh.cells[cell][a];
                         Eigen::Map<Six>(sum[node].data()) += values.col(a);
                         weight[node] += gradients.sum;
                       }
                     });
  for (size_t k = 0; k < sum.size(); ++k)
    if (weight[k] > 0.0) Eigen::Map<Six>(sum[k].data()) /= weight[k];
  return sum;
}

StressError recovered_error(const mesh::SolidMesh& mesh, const material::Material& material, const base::Points3& u) {
  const auto nodal = nodal_stress(mesh, material, u);
  const double E = material::young(material), nu = material::poisson(material);
  const auto rule = mesh::stiffness_rule(mesh.kind);
  StressError sum;
  each_stressed_cell(mesh, material, u,
                     [&]<mesh::SolidKind kind>(const SolidElement<kind>&, int cell,
                                               const CellGradients<kind>& gradients, const auto& at_points) {
                       for (int g = 0; g < SolidElement<kind>::points; ++g) {
                         const auto N = mesh::shape_functions(kind, rule[g].xi);
                         Six smooth = Six::Zero();
                         for (int a = 0; a < SolidElement<kind>::nodes; ++a)
                           smooth += N[a] * Eigen::Map<const Six>(nodal[mesh.cells[cell][a]].data());
                         const Six computed = at_points.col(g);
                         sum.difference += gradients.volume[g] * stress_energy(smooth - computed, E, nu);
                         sum.energy += gradients.volume[g] * stress_energy(computed, E, nu);
                       }
                     });
  return sum;
}

}  // namespace reye::fem
