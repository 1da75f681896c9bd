#include "adapt/transfer/recovery.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

namespace reye::adapt {

namespace {

using base::Vec2;

using Lists = std::vector<std::vector<int>>;

Lists cells_at_nodes(const mesh::Mesh& mesh) {
  Lists cells(mesh.X.size());
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) cells[mesh.cells[cell][a]].push_back(cell);
  return cells;
}

/// The cells of a patch and all that share a node with them.
std::vector<int> grown(const mesh::Mesh& mesh, const Lists& around, const std::vector<int>& patch) {
  std::vector<int> result;
  for (int cell : patch)
    for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) {
      const auto& cells = around[mesh.cells[cell][a]];
      result.insert(result.end(), cells.begin(), cells.end());
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Weights w_i of equation (1), and their squared norm.
struct Fit {
  std::vector<int> points;
  std::vector<double> weights;
  double amplification = 0.0;
};

Fit fit(const GaussPoints& gauss, const std::vector<int>& patch, const Vec2& X) {
  Fit result;
  Vec2 mean = Vec2::Zero();
  for (int cell : patch)
    for (int g = 0; g < gauss.per_cell; ++g) result.points.push_back(cell * gauss.per_cell + g);
  const auto n = static_cast<double>(result.points.size());
  for (int i : result.points) mean += gauss.x[i] / n;
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  for (int i : result.points) S += (gauss.x[i] - mean) * (gauss.x[i] - mean).transpose();
  constexpr double round_off = 1e-14;
  const bool on_a_line = S.determinant() <= round_off * S.trace() * S.trace();
  const Vec2 slope = on_a_line ? Vec2(0.0, 0.0) : Vec2(S.inverse() * (X - mean));
  for (int i : result.points) result.weights.push_back(1.0 / n + slope.dot(gauss.x[i] - mean));
  result.amplification = on_a_line ? std::numeric_limits<double>::infinity() : 1.0 / n + slope.dot(X - mean);
  return result;
}

Fit fit_around(const mesh::Mesh& mesh, const GaussPoints& gauss, const Lists& around, int node) {
  auto patch = around[node];
  for (;;) {
    auto found = fit(gauss, patch, mesh.X[node]);
    if (found.amplification <= 1.0) return found;
    auto larger = grown(mesh, around, patch);
    if (larger.size() == patch.size()) return found;
    patch = std::move(larger);
  }
}

}  // namespace

base::Matrix at_nodes(const mesh::Mesh& mesh, const GaussPoints& points, const base::Matrix& values) {
  const auto around = cells_at_nodes(mesh);
  base::Matrix result = base::Matrix::Zero(mesh.node_count(), values.cols());
  for (int node = 0; node < mesh.node_count(); ++node) {
    const Fit found = fit_around(mesh, points, around, node);
    for (std::size_t k = 0; k < found.points.size(); ++k)
      result.row(node) += found.weights[k] * values.row(found.points[k]);
  }
  return result;
}

}  // namespace reye::adapt
