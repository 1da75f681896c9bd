#include "fem/stiffness.hpp"

#include "fem/element.hpp"
#include "fem/nodal_average.hpp"
#include "fem/pattern.hpp"
#include "material/stress.hpp"

namespace reye::fem {

using base::SparseMatrix;

namespace {

/// Ke of a cell with n nodes, n = 4 or 8: fixed sizes are several times faster.
template <int n>
Eigen::Matrix<double, 2 * n, 2 * n> cell_stiffness(const CellStrains& s, const Eigen::Matrix4d& C) {
  Eigen::Matrix<double, 2 * n, 2 * n> Ke = Eigen::Matrix<double, 2 * n, 2 * n>::Zero();
  for (int g = 0; g < s.count; ++g) {
    const Eigen::Matrix<double, 4, 2 *n> B = s.points[g].B.leftCols<2 * n>(), CB = C * B;
    Ke.noalias() += s.points[g].volume * (B.transpose() * CB);
  }
  return Ke;
}

using PointStress = Eigen::Matrix<double, 4, 4>;  // column: Gauss point

PointStress point_stress(const Mesh& mesh, int cell, const CellStrains& s, const Eigen::Matrix4d& C,
                         const base::Points& u) {
  Eigen::Matrix<double, 2 * mesh::most_cell_nodes, 1> ue = Eigen::Matrix<double, 2 * mesh::most_cell_nodes, 1>::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) ue.segment<2>(2 * a) = u[mesh.cells[cell][a]];
  const bool first_order = mesh::order(mesh.kind) == 1;
  PointStress values = PointStress::Zero();
  for (int g = 0; g < s.count; ++g) {
    const auto& B = s.points[g].B;
    const Eigen::Vector4d strain = first_order ? Eigen::Vector4d(B.leftCols<8>() * ue.head<8>()) : B * ue;
    values.col(g) = C * strain;
  }
  return values;
}

/// sigma : C^-1 : sigma = ((1 + nu) sigma : sigma - nu (tr sigma)^2) / E, of (11, 22, 12, 33).
double energy(const Eigen::Vector4d& s, double E, double nu) {
  const double trace = s[0] + s[1] + s[3];
  return ((1.0 + nu) * (s.squaredNorm() + s[2] * s[2]) - nu * trace * trace) / E;
}

}  // namespace

SparseMatrix stiffness(const Mesh& mesh, const material::Material& material, Analysis analysis, bool b_bar) {
  const Pattern pattern(mesh);
  SparseMatrix K = pattern.zero();
  const Eigen::Matrix4d C = material::tangent(material, analysis);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellStrains s = strain_points(mesh, cell, analysis, b_bar);
    const int count = mesh::nodes_per_cell(mesh.kind);
    if (mesh::order(mesh.kind) == 1)
      pattern.add_cell(cell_stiffness<4>(s, C), mesh.cells[cell], count, K);
    else
      pattern.add_cell(cell_stiffness<8>(s, C), mesh.cells[cell], count, K);
  }
  return K;
}

std::vector<Stress> nodal_stress(const Mesh& mesh, const material::Material& material, Analysis analysis, bool b_bar,
                                 const base::Points& u) {
  const Eigen::Matrix4d C = material::tangent(material, analysis);
  NodalAverage<4> average(mesh);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellStrains s = strain_points(mesh, cell, analysis, b_bar);
    double volume = 0.0;
    for (int g = 0; g < s.count; ++g) volume += s.points[g].volume;
    average.add(cell, point_stress(mesh, cell, s, C, u), volume);
  }
  std::vector<Stress> result;
  for (const auto& value : average.values()) result.push_back({value[0], value[1], value[2], value[3]});
  return result;
}

StressError recovered_error(const Mesh& mesh, const material::Material& material, Analysis analysis, bool b_bar,
                            const base::Points& u) {
  const auto nodal = nodal_stress(mesh, material, analysis, b_bar, u);
  const Eigen::Matrix4d C = material::tangent(material, analysis);
  const auto [E, nu] = std::visit([](const auto& m) { return std::array{m.E_MPa, m.nu}; }, material);
  const auto rule = stiffness_rule(mesh.kind);
  StressError sum;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellStrains s = strain_points(mesh, cell, analysis, b_bar);
    const PointStress computed = point_stress(mesh, cell, s, C, u);
    for (int g = 0; g < s.count; ++g) {
      const NodeValues N = shape_functions(mesh.kind, rule[g].xi);
      Eigen::Vector4d smooth = Eigen::Vector4d::Zero();
      for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a)
        smooth += N[a] * Eigen::Map<const Eigen::Vector4d>(nodal[mesh.cells[cell][a]].data());
      sum.difference += s.points[g].volume * energy(smooth - computed.col(g), E, nu);
      sum.energy += s.points[g].volume * energy(computed.col(g), E, nu);
    }
  }
  return sum;
}

}  // namespace reye::fem
