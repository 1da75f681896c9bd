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
Eigen::Matrix<double, 2 * n, 2 * n> cell_stiffness(const CellStrains<n>& s, const Eigen::Matrix4d& C) {
  Eigen::Matrix<double, 2 * n, 2 * n> Ke = Eigen::Matrix<double, 2 * n, 2 * n>::Zero();
  for (int g = 0; g < s.count; ++g) {
    const Eigen::Matrix<double, 4, 2 * n> CB = C.lazyProduct(s.points[g].B);
    Ke += s.points[g].volume * s.points[g].B.transpose().lazyProduct(CB);
  }
  return Ke;
}

template <int n>
void add_stiffness(const Mesh& mesh, const Eigen::Matrix4d& C, Analysis analysis, bool b_bar, const Pattern& pattern,
                   SparseMatrix& K) {
  const int count = mesh::nodes_per_cell(mesh.kind);
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    pattern.add_cell(cell_stiffness<n>(strain_points<n>(mesh, cell, analysis, b_bar), C), mesh.cells[cell], count, K);
}

/// Stresses at the Gauss points of a cell, column by column, and their volumes.
struct PointStress {
  Eigen::Matrix4d stress = Eigen::Matrix4d::Zero();
  Eigen::Vector4d volume = Eigen::Vector4d::Zero();
};

template <int n>
PointStress point_stress_of(const Mesh& mesh, int cell, const Eigen::Matrix4d& C, Analysis analysis, bool b_bar,
                            const base::Points& u) {
  const CellStrains<n> s = strain_points<n>(mesh, cell, analysis, b_bar);
  Eigen::Matrix<double, 2 * n, 1> ue = Eigen::Matrix<double, 2 * n, 1>::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) ue.template segment<2>(2 * a) = u[mesh.cells[cell][a]];
  PointStress result;
  for (int g = 0; g < s.count; ++g) {
    const Eigen::Vector4d strain = s.points[g].B.lazyProduct(ue);
    result.stress.col(g) = C * strain;
    result.volume[g] = s.points[g].volume;
  }
  return result;
}

PointStress point_stress(const Mesh& mesh, int cell, const Eigen::Matrix4d& C, Analysis analysis, bool b_bar,
                         const base::Points& u) {
  return mesh::order(mesh.kind) == 1 ? point_stress_of<4>(mesh, cell, C, analysis, b_bar, u)
                                     : point_stress_of<8>(mesh, cell, C, analysis, b_bar, u);
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
  const bool first_order = mesh::order(mesh.kind) == 1;
  (first_order ? add_stiffness<4> : add_stiffness<8>)(mesh, C, analysis, b_bar, pattern, K);
  return K;
}

std::vector<Stress> nodal_stress(const Mesh& mesh, const material::Material& material, Analysis analysis, bool b_bar,
                                 const base::Points& u) {
  const Eigen::Matrix4d C = material::tangent(material, analysis);
  NodalAverage<4> average(mesh);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const PointStress computed = point_stress(mesh, cell, C, analysis, b_bar, u);
    average.add(cell, computed.stress, computed.volume.sum());
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
  const auto rule = tabulated_rule(mesh.kind);
  StressError sum;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const PointStress computed = point_stress(mesh, cell, C, analysis, b_bar, u);
    for (int g = 0; g < static_cast<int>(rule.size()); ++g) {
      const NodeValues& N = rule[g].N;
      Eigen::Vector4d smooth = Eigen::Vector4d::Zero();
      for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a)
        smooth += N[a] * Eigen::Map<const Eigen::Vector4d>(nodal[mesh.cells[cell][a]].data());
      sum.difference += computed.volume[g] * energy(smooth - computed.stress.col(g), E, nu);
      sum.energy += computed.volume[g] * energy(computed.stress.col(g), E, nu);
    }
  }
  return sum;
}

}  // namespace reye::fem
