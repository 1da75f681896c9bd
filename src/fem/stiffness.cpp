#include "fem/stiffness.hpp"

#include <algorithm>

#include "fem/element.hpp"
#include "material/stress.hpp"

namespace reye::fem {

using base::SparseMatrix;

namespace {

/// Sorted neighbours of every node (itself included): the sparsity of K, 2 x 2 block by block.
struct Adjacency {
  std::vector<int> start;  ///< n + 1
  std::vector<int> nodes;

  int position(int of, int neighbour) const {
    const auto first = nodes.begin() + start[of];
    return static_cast<int>(std::lower_bound(first, nodes.begin() + start[of + 1], neighbour) - first);
  }
  int count(int of) const { return start[of + 1] - start[of]; }
};

Adjacency adjacency(const Mesh& mesh) {
  const int count = mesh::nodes_per_cell(mesh.kind);
  std::vector<std::vector<int>> lists(mesh.X.size());
  for (const auto& cell : mesh.cells)
    for (int a = 0; a < count; ++a) lists[cell[a]].insert(lists[cell[a]].end(), cell.begin(), cell.begin() + count);
  Adjacency graph{{0}, {}};
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    graph.nodes.insert(graph.nodes.end(), list.begin(), std::unique(list.begin(), list.end()));
    graph.start.push_back(static_cast<int>(graph.nodes.size()));
  }
  return graph;
}

/// The zero matrix with every entry of the pattern present.
SparseMatrix pattern(const Adjacency& graph) {
  const int n = static_cast<int>(graph.start.size()) - 1;
  SparseMatrix K(2 * n, 2 * n);
  K.resizeNonZeros(4 * static_cast<Eigen::Index>(graph.nodes.size()));
  int* outer = K.outerIndexPtr();
  int* inner = K.innerIndexPtr();
  for (int b = 0; b < n; ++b)
    for (int c = 0; c < 2; ++c) {
      int at = 4 * graph.start[b] + 2 * c * graph.count(b);
      outer[2 * b + c] = at;
      for (int k = graph.start[b]; k < graph.start[b + 1]; ++k)
        for (int r = 0; r < 2; ++r) inner[at++] = 2 * graph.nodes[k] + r;
    }
  outer[2 * n] = 4 * static_cast<int>(graph.nodes.size());
  std::fill_n(K.valuePtr(), K.nonZeros(), 0.0);
  return K;
}

/// Ke of a cell with n nodes, n = 4 or 8: fixed sizes are several times faster.
template <int n>
Eigen::Matrix<double, 2 * n, 2 * n> cell_stiffness(const CellStrains& s, const Eigen::Matrix4d& C) {
  Eigen::Matrix<double, 2 * n, 2 * n> Ke = Eigen::Matrix<double, 2 * n, 2 * n>::Zero();
  for (int g = 0; g < s.count; ++g) {
    const Eigen::Matrix<double, 4, 2 * n> B = s.points[g].B.leftCols<2 * n>(), CB = C * B;
    Ke.noalias() += s.points[g].volume * (B.transpose() * CB);
  }
  return Ke;
}

template <class CellMatrix>
void add_cell(const CellMatrix& Ke, const mesh::Cell& cell, int count, const Adjacency& graph, SparseMatrix& K) {
  for (int b = 0; b < count; ++b)
    for (int a = 0; a < count; ++a) {
      const int slot = 2 * graph.position(cell[b], cell[a]);
      for (int c = 0; c < 2; ++c) {
        double* entry = K.valuePtr() + K.outerIndexPtr()[2 * cell[b] + c] + slot;
        entry[0] += Ke(2 * a, 2 * b + c);
        entry[1] += Ke(2 * a + 1, 2 * b + c);
      }
    }
}

using PointStress = Eigen::Matrix<double, 4, 4>;                     // column: Gauss point
using CellStress = Eigen::Matrix<double, 4, mesh::most_cell_nodes>;  // column: node

/// Values at the nodes of the polynomial through the Gauss points: constant, linear through three points, or bilinear
/// through 2 x 2. It is a shape function of first order in the coordinates in which the points are the corners:
///   tri6: (xi - 1/6) / (1/2),   quad4 and quad8: sqrt(3) xi.
CellStress to_nodes(mesh::CellKind kind, const PointStress& at_points) {
  if (kind == mesh::CellKind::tri3) return at_points.col(0).replicate<1, mesh::most_cell_nodes>();
  const bool triangle = mesh::corners(kind) == 3;
  CellStress values = CellStress::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(kind); ++a) {
    const Vec2 xi = mesh::reference_node(kind, a);
    constexpr double root = 1.7320508075688772;
    const NodeValues N = triangle ? shape_functions(mesh::CellKind::tri3, 2.0 * xi - Vec2(1.0 / 3.0, 1.0 / 3.0))
                                  : shape_functions(mesh::CellKind::quad4, root * xi);
    values.col(a) = at_points * N.head<4>();
  }
  return values;
}

CellStress cell_stress(const Mesh& mesh, int cell, const CellStrains& s, const Eigen::Matrix4d& C,
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
  return to_nodes(mesh.kind, values);
}

}  // namespace

SparseMatrix stiffness(const Mesh& mesh, const material::Material& material, Analysis analysis, bool b_bar) {
  const Adjacency graph = adjacency(mesh);
  SparseMatrix K = pattern(graph);
  const Eigen::Matrix4d C = material::tangent(material, analysis);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellStrains s = strain_points(mesh, cell, analysis, b_bar);
    const int count = mesh::nodes_per_cell(mesh.kind);
    if (mesh::order(mesh.kind) == 1)
      add_cell(cell_stiffness<4>(s, C), mesh.cells[cell], count, graph, K);
    else
      add_cell(cell_stiffness<8>(s, C), mesh.cells[cell], count, graph, K);
  }
  return K;
}

std::vector<Stress> nodal_stress(const Mesh& mesh, const material::Material& material, Analysis analysis, bool b_bar,
                                 const base::Points& u) {
  const Eigen::Matrix4d C = material::tangent(material, analysis);
  std::vector<Eigen::Vector4d> sum(mesh.X.size(), Eigen::Vector4d::Zero());
  std::vector<double> weight(mesh.X.size(), 0.0);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellStrains s = strain_points(mesh, cell, analysis, b_bar);
    const CellStress values = cell_stress(mesh, cell, s, C, u);
    double volume = 0.0;
    for (int g = 0; g < s.count; ++g) volume += s.points[g].volume;
    for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) {
      sum[mesh.cells[cell][a]] += volume * values.col(a);
      weight[mesh.cells[cell][a]] += volume;
    }
  }
  std::vector<Stress> result(mesh.X.size());
  for (size_t k = 0; k < result.size(); ++k)
    for (int i = 0; i < 4; ++i) result[k][i] = sum[k][i] / weight[k];
  return result;
}

}  // namespace reye::fem
