#include "fem/element.hpp"

#include <Eigen/LU>
#include <cmath>
#include <string>

#include "base/errors.hpp"

namespace reye::fem {

using mesh::CellKind;

namespace {

constexpr double gauss = 0.57735026918962576451;  // 1 / sqrt(3)

const std::array<CellPoint, 1> centroid{{{{1.0 / 3.0, 1.0 / 3.0}, 0.5}}};
const std::array<CellPoint, 3> triangle{{{{1.0 / 6.0, 1.0 / 6.0}, 1.0 / 6.0},
                                         {{2.0 / 3.0, 1.0 / 6.0}, 1.0 / 6.0},
                                         {{1.0 / 6.0, 2.0 / 3.0}, 1.0 / 6.0}}};
const std::array<CellPoint, 4> square{
    {{{-gauss, -gauss}, 1.0}, {{gauss, -gauss}, 1.0}, {{gauss, gauss}, 1.0}, {{-gauss, gauss}, 1.0}}};

using Corners = Eigen::Matrix<double, 4, 2>;

Corners corners_of(const Mesh& mesh, int cell) {
  Corners X = Corners::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) X.row(a) = mesh.X[mesh.cells[cell][a]];
  return X;
}

double positive(double det, int cell) {
  if (!(det > 0.0)) throw base::MeshError("cell " + std::to_string(cell) + " has a Jacobian that is not positive");
  return det;
}

StrainPoint strain_point(const Corners& X, CellKind kind, const CellPoint& at, Analysis analysis, int cell) {
  const Corners dN_dxi = shape_gradients(kind, at.xi);
  const Eigen::Matrix2d J = dN_dxi.transpose() * X;  // row i: dX/dxi_i
  const double det = positive(J.determinant(), cell);
  const Eigen::Matrix<double, 4, 2> dN = dN_dxi * J.inverse().transpose();
  const Eigen::Vector4d N = shape_functions(kind, at.xi);
  const double r = N.dot(X.col(0));
  StrainPoint p;
  p.B.setZero();
  for (int a = 0; a < mesh::nodes_per_cell(kind); ++a) {
    p.B(0, 2 * a) = p.B(2, 2 * a + 1) = dN(a, 0);
    p.B(1, 2 * a + 1) = p.B(2, 2 * a) = dN(a, 1);
    if (analysis == Analysis::axisymmetric) p.B(3, 2 * a) = N[a] / r;
  }
  p.volume = at.weight * det * base::out_of_plane(analysis, r);
  return p;
}

/// Equation (1) of the README.
void average_volumetric_part(CellStrains& s) {
  using Row = Eigen::Matrix<double, 1, 8>;
  std::array<Row, 4> b;
  Row mean = Row::Zero();
  double volume = 0.0;
  for (int g = 0; g < s.count; ++g) {
    b[g] = s.points[g].B.row(0) + s.points[g].B.row(1) + s.points[g].B.row(3);
    mean += s.points[g].volume * b[g];
    volume += s.points[g].volume;
  }
  mean /= volume;
  for (int g = 0; g < s.count; ++g)
    for (int row : {0, 1, 3}) s.points[g].B.row(row) += (mean - b[g]) / 3.0;
}

}  // namespace

std::span<const CellPoint> stiffness_rule(CellKind kind) {
  if (kind == CellKind::tri3) return centroid;
  return square;
}

std::span<const CellPoint> volume_rule(CellKind kind) {
  if (kind == CellKind::tri3) return triangle;
  return square;
}

Eigen::Vector4d shape_functions(CellKind kind, const Vec2& xi) {
  const double r = xi.x(), s = xi.y();
  if (kind == CellKind::tri3) return {1.0 - r - s, r, s, 0.0};
  return Eigen::Vector4d{(1 - r) * (1 - s), (1 + r) * (1 - s), (1 + r) * (1 + s), (1 - r) * (1 + s)} / 4.0;
}

Eigen::Matrix<double, 4, 2> shape_gradients(CellKind kind, const Vec2& xi) {
  const double r = xi.x(), s = xi.y();
  Eigen::Matrix<double, 4, 2> d;
  if (kind == CellKind::tri3)
    d << -1, -1, 1, 0, 0, 1, 0, 0;
  else
    d << -(1 - s), -(1 - r), 1 - s, -(1 + r), 1 + s, 1 + r, -(1 + s), 1 - r;
  return kind == CellKind::tri3 ? d : Eigen::Matrix<double, 4, 2>(d / 4.0);
}

CellStrains strain_points(const Mesh& mesh, int cell, Analysis analysis, bool b_bar) {
  const Corners X = corners_of(mesh, cell);
  CellStrains s;
  for (const CellPoint& at : stiffness_rule(mesh.kind))
    s.points[s.count++] = strain_point(X, mesh.kind, at, analysis, cell);
  if (b_bar && mesh.kind == CellKind::quad4 && analysis != Analysis::plane_stress) average_volumetric_part(s);
  return s;
}

std::vector<VolumePoint> volume_points(const Mesh& mesh, int cell, Analysis analysis) {
  const Corners X = corners_of(mesh, cell);
  std::vector<VolumePoint> points;
  for (const CellPoint& at : volume_rule(mesh.kind)) {
    const Eigen::Vector4d N = shape_functions(mesh.kind, at.xi);
    const Eigen::Matrix2d J = shape_gradients(mesh.kind, at.xi).transpose() * X;
    const double det = positive(J.determinant(), cell);
    points.push_back({N, at.weight * det * base::out_of_plane(analysis, N.dot(X.col(0)))});
  }
  return points;
}

}  // namespace reye::fem
