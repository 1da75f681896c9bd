#include "mesh/solid/solid_shape.hpp"

namespace reye::mesh {

namespace {

constexpr std::array<std::array<int, 2>, 6> tet_edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<int, 2>, 3> triangle_edges{{{0, 1}, {1, 2}, {2, 0}}};

const std::array<Vec3, 8> cube{Vec3{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                               Vec3{-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
const std::array<Vec2, 4> flat_square{Vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

/// Quadratic functions of barycentric coordinates L, (2 L_i - 1) L_i at corners and 4 L_i L_j between them.
template <class Values, class Edges>
Values quadratic(const Values& L, int corners, const Edges& edges) {
  Values N = Values::Zero();
  for (int i = 0; i < corners; ++i) N[i] = (2.0 * L[i] - 1.0) * L[i];
  for (size_t e = 0; e < edges.size(); ++e) N[corners + static_cast<int>(e)] = 4.0 * L[edges[e][0]] * L[edges[e][1]];
  return N;
}

template <class Gradients, class Values, class Edges>
Gradients quadratic_gradients(const Values& L, const Gradients& dL, int corners, const Edges& edges) {
  Gradients d = Gradients::Zero();
  for (int i = 0; i < corners; ++i) d.row(i) = (4.0 * L[i] - 1.0) * dL.row(i);
  for (size_t e = 0; e < edges.size(); ++e) {
    const auto [i, j] = edges[e];
    d.row(corners + static_cast<int>(e)) = 4.0 * (L[i] * dL.row(j) + L[j] * dL.row(i));
  }
  return d;
}

SolidValues tet_values(const Vec3& xi) {
  SolidValues L = SolidValues::Zero();
  L.head<4>() << 1.0 - xi.sum(), xi;
  return L;
}

SolidGradients tet_gradients() {
  SolidGradients d = SolidGradients::Zero();
  d.row(0).setConstant(-1.0);
  d.block<3, 3>(1, 0).setIdentity();
  return d;
}

FacetValues triangle_values(const Vec2& xi) {
  FacetValues L = FacetValues::Zero();
  L.head<3>() << 1.0 - xi.sum(), xi;
  return L;
}

FacetGradients triangle_gradients() {
  FacetGradients d = FacetGradients::Zero();
  d.row(0).setConstant(-1.0);
  d.block<2, 2>(1, 0).setIdentity();
  return d;
}

}  // namespace

SolidValues shape_functions(SolidKind kind, const Vec3& xi) {
  if (kind != SolidKind::hex8) {
    const SolidValues L = tet_values(xi);
    return kind == SolidKind::tet4 ? L : quadratic(L, 4, tet_edges);
  }
  SolidValues N = SolidValues::Zero();
  for (int a = 0; a < 8; ++a) N[a] = (Vec3::Ones() + cube[a].cwiseProduct(xi)).prod() / 8.0;
  return N;
}

SolidGradients shape_gradients(SolidKind kind, const Vec3& xi) {
  if (kind == SolidKind::tet4) return tet_gradients();
  if (kind == SolidKind::tet10) return quadratic_gradients(tet_values(xi), tet_gradients(), 4, tet_edges);
  SolidGradients d = SolidGradients::Zero();
  for (int a = 0; a < 8; ++a) {
    const Vec3 f = Vec3::Ones() + cube[a].cwiseProduct(xi);
    d.row(a) << cube[a].x() * f.y() * f.z(), cube[a].y() * f.x() * f.z(), cube[a].z() * f.x() * f.y();
  }
  return d / 8.0;
}

FacetValues shape_functions(FacetKind kind, const Vec2& xi) {
  if (kind != FacetKind::quad4) {
    const FacetValues L = triangle_values(xi);
    return kind == FacetKind::tri3 ? L : quadratic(L, 3, triangle_edges);
  }
  FacetValues N = FacetValues::Zero();
  for (int a = 0; a < 4; ++a) N[a] = (1.0 + flat_square[a].x() * xi.x()) * (1.0 + flat_square[a].y() * xi.y()) / 4.0;
  return N;
}

FacetGradients shape_gradients(FacetKind kind, const Vec2& xi) {
  if (kind == FacetKind::tri3) return triangle_gradients();
  if (kind == FacetKind::tri6) return quadratic_gradients(triangle_values(xi), triangle_gradients(), 3, triangle_edges);
  FacetGradients d = FacetGradients::Zero();
  for (int a = 0; a < 4; ++a)
    d.row(a) << flat_square[a].x() * (1.0 + flat_square[a].y() * xi.y()),
        flat_square[a].y() * (1.0 + flat_square[a].x() * xi.x());
  return d / 4.0;
}

std::array<int, 2> edge_of(SolidKind, int edge) { return tet_edges[edge]; }
std::array<int, 2> edge_of(FacetKind, int edge) { return triangle_edges[edge]; }

Vec3 reference_node(SolidKind kind, int a) {
  if (kind == SolidKind::hex8) return cube[a];
  static const std::array<Vec3, 4> tet{Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (a < 4) return tet[a];
  return 0.5 * (tet[tet_edges[a - 4][0]] + tet[tet_edges[a - 4][1]]);
}

Vec2 reference_node(FacetKind kind, int a) {
  if (kind == FacetKind::quad4) return flat_square[a];
  static const std::array<Vec2, 3> triangle{Vec2{0, 0}, {1, 0}, {0, 1}};
  if (a < 3) return triangle[a];
  return 0.5 * (triangle[triangle_edges[a - 3][0]] + triangle[triangle_edges[a - 3][1]]);
}

}  // namespace reye::mesh
