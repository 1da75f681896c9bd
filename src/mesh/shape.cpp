#include "mesh/shape.hpp"

namespace reye::mesh {

namespace {

using Values = Eigen::Vector4d;
using Gradients = Eigen::Matrix<double, 4, 2>;

Values linear_functions(CellKind kind, double r, double s) {
  if (corners(kind) == 3) return {1.0 - r - s, r, s, 0.0};
  return Values{(1 - r) * (1 - s), (1 + r) * (1 - s), (1 + r) * (1 + s), (1 - r) * (1 + s)} / 4.0;
}

Gradients linear_gradients(CellKind kind, double r, double s) {
  Gradients d;
  if (corners(kind) == 3)
    d << -1, -1, 1, 0, 0, 1, 0, 0;
  else
    d << -(1 - s), -(1 - r), 1 - s, -(1 + r), 1 + s, 1 + r, -(1 + s), 1 - r;
  return corners(kind) == 3 ? d : Gradients(d / 4.0);
}

/// The bubble of an edge, 1 at its middle and 0 at all other nodes: 4 L_a L_b on the triangle,
/// 1/2 (1 - r^2)(1 -+ s) or 1/2 (1 +- r)(1 - s^2) on the square.
double mid_function(CellKind kind, int edge, const Vec2& xi) {
  const double r = xi.x(), s = xi.y();
  if (kind == CellKind::tri6) {
    const Values L = linear_functions(kind, r, s);
    return 4.0 * L[edge] * L[(edge + 1) % 3];
  }
  const Vec2 at = reference_node(kind, 4 + edge);
  return edge % 2 == 0 ? 0.5 * (1 - r * r) * (1 + at.y() * s) : 0.5 * (1 + at.x() * r) * (1 - s * s);
}

Eigen::RowVector2d mid_gradient(CellKind kind, int edge, const Vec2& xi) {
  const double r = xi.x(), s = xi.y();
  if (kind == CellKind::tri6) {
    const Values L = linear_functions(kind, r, s);
    const Gradients dL = linear_gradients(kind, r, s);
    const int next = (edge + 1) % 3;
    return 4.0 * (L[next] * dL.row(edge) + L[edge] * dL.row(next));
  }
  const Vec2 at = reference_node(kind, 4 + edge);
  if (edge % 2 == 0) return {-r * (1 + at.y() * s), 0.5 * (1 - r * r) * at.y()};
  return {0.5 * at.x() * (1 - s * s), -s * (1 + at.x() * r)};
}

}  // namespace

// Second order: the functions of first order with half the bubble of each adjacent edge taken off, and the bubbles.

NodeValues shape_functions(CellKind kind, const Vec2& xi) {
  NodeValues N = NodeValues::Zero();
  N.head<4>() = linear_functions(kind, xi.x(), xi.y());
  if (order(kind) == 1) return N;
  const int n = corners(kind);
  for (int e = 0; e < n; ++e) {
    N[n + e] = mid_function(kind, e, xi);
    N[e] -= 0.5 * N[n + e];
    N[(e + 1) % n] -= 0.5 * N[n + e];
  }
  return N;
}

NodeGradients shape_gradients(CellKind kind, const Vec2& xi) {
  NodeGradients d = NodeGradients::Zero();
  d.topRows<4>() = linear_gradients(kind, xi.x(), xi.y());
  if (order(kind) == 1) return d;
  const int n = corners(kind);
  for (int e = 0; e < n; ++e) {
    d.row(n + e) = mid_gradient(kind, e, xi);
    d.row(e) -= 0.5 * d.row(n + e);
    d.row((e + 1) % n) -= 0.5 * d.row(n + e);
  }
  return d;
}

Vec2 reference_node(CellKind kind, int a) {
  static const std::array<Vec2, 6> triangle{Vec2{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
  static const std::array<Vec2, 8> square{Vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  return corners(kind) == 3 ? triangle[a] : square[a];
}

}  // namespace reye::mesh
