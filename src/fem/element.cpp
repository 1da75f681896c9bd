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
const std::array<CellPoint, 3> triangle{
    {{{1.0 / 6.0, 1.0 / 6.0}, 1.0 / 6.0}, {{2.0 / 3.0, 1.0 / 6.0}, 1.0 / 6.0}, {{1.0 / 6.0, 2.0 / 3.0}, 1.0 / 6.0}}};
const std::array<CellPoint, 4> square{
    {{{-gauss, -gauss}, 1.0}, {{gauss, -gauss}, 1.0}, {{gauss, gauss}, 1.0}, {{-gauss, gauss}, 1.0}}};

const std::array<CellPoint, 9> square9 = [] {
  const double at[] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, weight[] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  std::array<CellPoint, 9> points;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) points[3 * j + i] = {{at[i], at[j]}, weight[i] * weight[j]};
  return points;
}();

/// Radon's rule: the centroid, and two triples on the medians.
const std::array<CellPoint, 7> triangle7 = [] {
  std::array<CellPoint, 7> points{{{{1.0 / 3.0, 1.0 / 3.0}, 9.0 / 80.0}}};
  int k = 1;
  for (double root : {std::sqrt(15.0), -std::sqrt(15.0)}) {
    const double near = (6.0 + root) / 21.0, far = 1.0 - 2.0 * near, weight = (155.0 + root) / 2400.0;
    for (const Vec2& xi : {Vec2{near, near}, Vec2{far, near}, Vec2{near, far}}) points[k++] = {xi, weight};
  }
  return points;
}();

/// Positions of the nodes of a cell: n = 4 in first order (a triangle leaves the last row zero), 8 in second.
template <int n>
using Nodes = Eigen::Matrix<double, n, 2>;

template <int n>
Nodes<n> nodes_of(const Mesh& mesh, int cell) {
  Nodes<n> X = Nodes<n>::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) X.row(a) = mesh.X[mesh.cells[cell][a]];
  return X;
}

double positive(double det, int cell) {
  if (!(det > 0.0)) throw base::MeshError("cell " + std::to_string(cell) + " has a Jacobian that is not positive");
  return det;
}

template <int n>
StrainPoint<n> strain_point(const Nodes<n>& X, CellKind kind, const RulePoint& point, Analysis analysis, int cell) {
  const auto dN_dxi = point.dN_dxi.topRows<n>();
  const Eigen::Matrix2d J = dN_dxi.transpose().lazyProduct(X);  // row i: dX/dxi_i
  const double det = positive(J.determinant(), cell);
  const Nodes<n> dN = dN_dxi.lazyProduct(Eigen::Matrix2d(J.inverse().transpose()));
  const double r = point.N.head<n>().dot(X.col(0));
  StrainPoint<n> p;
  p.B.setZero();
  for (int a = 0; a < mesh::nodes_per_cell(kind); ++a) {
    p.B(0, 2 * a) = p.B(2, 2 * a + 1) = dN(a, 0);
    p.B(1, 2 * a + 1) = p.B(2, 2 * a) = dN(a, 1);
    if (analysis == Analysis::axisymmetric) p.B(3, 2 * a) = point.N[a] / r;
  }
  p.volume = point.at.weight * det * base::out_of_plane(analysis, r);
  return p;
}

template <int n>
std::vector<VolumePoint> volume_points_of(const Mesh& mesh, int cell, Analysis analysis) {
  const Nodes<n> X = nodes_of<n>(mesh, cell);
  std::vector<VolumePoint> points;
  for (const CellPoint& at : volume_rule(mesh.kind)) {
    const NodeValues N = shape_functions(mesh.kind, at.xi);
    const Eigen::Matrix2d J = shape_gradients(mesh.kind, at.xi).topRows<n>().transpose().lazyProduct(X);
    const double det = positive(J.determinant(), cell);
    points.push_back({N, at.weight * det * base::out_of_plane(analysis, N.head<n>().dot(X.col(0)))});
  }
  return points;
}

/// Equation (1) of the README.
void average_volumetric_part(CellStrains<4>& s) {
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

RulePoint tabulated(CellKind kind, const CellPoint& at) {
  return {at, shape_functions(kind, at.xi), shape_gradients(kind, at.xi)};
}

std::vector<RulePoint> tabulated(CellKind kind) {
  std::vector<RulePoint> points;
  for (const CellPoint& at : stiffness_rule(kind)) points.push_back(tabulated(kind, at));
  return points;
}

}  // namespace

std::span<const CellPoint> stiffness_rule(CellKind kind) {
  if (kind == CellKind::tri3) return centroid;
  if (kind == CellKind::tri6) return triangle;
  return square;
}

std::span<const CellPoint> volume_rule(CellKind kind) {
  if (kind == CellKind::tri3) return triangle;
  if (kind == CellKind::tri6) return triangle7;
  if (kind == CellKind::quad8) return square9;
  return square;
}

std::span<const RulePoint> tabulated_rule(CellKind kind) {
  static const std::array<std::vector<RulePoint>, 4> rules{tabulated(CellKind::tri3), tabulated(CellKind::quad4),
                                                           tabulated(CellKind::tri6), tabulated(CellKind::quad8)};
  return rules[static_cast<std::size_t>(kind)];
}

const RulePoint& centre_of_quad4() {
  static const RulePoint point = tabulated(CellKind::quad4, {Vec2::Zero(), 1.0});
  return point;
}

template <int n>
CellStrains<n> strain_points(const Mesh& mesh, int cell, Analysis analysis, bool b_bar) {
  const Nodes<n> X = nodes_of<n>(mesh, cell);
  CellStrains<n> s;
  for (const RulePoint& point : tabulated_rule(mesh.kind))
    s.points[s.count++] = strain_point<n>(X, mesh.kind, point, analysis, cell);
  if constexpr (n == 4)
    if (b_bar && mesh.kind == CellKind::quad4 && analysis != Analysis::plane_stress) average_volumetric_part(s);
  return s;
}

template CellStrains<4> strain_points<4>(const Mesh&, int, Analysis, bool);
template CellStrains<8> strain_points<8>(const Mesh&, int, Analysis, bool);

std::vector<VolumePoint> volume_points(const Mesh& mesh, int cell, Analysis analysis) {
  return mesh::order(mesh.kind) == 2 ? volume_points_of<8>(mesh, cell, analysis)
                                     : volume_points_of<4>(mesh, cell, analysis);
}

}  // namespace reye::fem
