#pragma once
#include <Eigen/Core>
#include <vector>

#include "fem/element.hpp"

namespace reye::fem {

/// Values at the nodes of a cell, one column each, from its Gauss points: those of the polynomial through the points:
/// constant, linear through three, or bilinear through 2 x 2. It is a shape function of first order in the coordinates
/// in which the points are the corners:
///   tri6: (xi - 1/6) / (1/2),   quad4 and quad8: sqrt(3) xi.
template <int size>
Eigen::Matrix<double, size, mesh::most_cell_nodes> to_nodes(mesh::CellKind kind,
                                                            const Eigen::Matrix<double, size, 4>& at_points) {
  Eigen::Matrix<double, size, mesh::most_cell_nodes> values;
  if (kind == mesh::CellKind::tri3) return at_points.col(0).template replicate<1, mesh::most_cell_nodes>();
  const bool triangle = mesh::corners(kind) == 3;
  values.setZero();
  for (int a = 0; a < mesh::nodes_per_cell(kind); ++a) {
    const Vec2 xi = mesh::reference_node(kind, a);
    constexpr double root = 1.7320508075688772;
    const NodeValues N = triangle ? shape_functions(mesh::CellKind::tri3, 2.0 * xi - Vec2(1.0 / 3.0, 1.0 / 3.0))
                                  : shape_functions(mesh::CellKind::quad4, root * xi);
    values.col(a) = at_points * N.head<4>();
  }
  return values;
}

/// A field known at the Gauss points of cells, averaged to the nodes with the volumes of the cells as weights.
template <int size>
class NodalAverage {
 public:
  explicit NodalAverage(const Mesh& mesh)
      : mesh_(mesh), sum_(mesh.X.size(), Value::Zero()), weight_(mesh.X.size(), 0.0) {}

  /// `at_points`: one column per Gauss point.
  void add(int cell, const Eigen::Matrix<double, size, 4>& at_points, double volume) {
    const auto values = to_nodes<size>(mesh_.kind, at_points);
    for (int a = 0; a < mesh::nodes_per_cell(mesh_.kind); ++a) {
      sum_[mesh_.cells[cell][a]] += volume * values.col(a);
      weight_[mesh_.cells[cell][a]] += volume;
    }
  }

  std::vector<Eigen::Matrix<double, size, 1>> values() const {
    auto result = sum_;
    for (size_t k = 0; k < result.size(); ++k) result[k] /= weight_[k];
    return result;
  }

 private:
  using Value = Eigen::Matrix<double, size, 1>;
  const Mesh& mesh_;
  std::vector<Value> sum_;
  std::vector<double> weight_;
};

}  // namespace reye::fem
