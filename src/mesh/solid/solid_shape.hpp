#pragma once
#include <span>

#include "base/linalg.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Shape functions of the cells of solids and of their facets, and rules of quadrature, on the reference shapes:
/// tetrahedron (0,0,0) (1,0,0) (0,1,0) (0,0,1), cube [-1, 1]^3, triangle (0,0) (1,0) (0,1), square [-1, 1]^2.
namespace reye::mesh {

using base::Vec2;

/// A value per node of a cell or facet, and a gradient per node, row by row; entries beyond its nodes are zero.
using SolidValues = Eigen::Matrix<double, most_solid_nodes, 1>;
using SolidGradients = Eigen::Matrix<double, most_solid_nodes, 3>;
using FacetValues = Eigen::Matrix<double, most_facet_nodes, 1>;
using FacetGradients = Eigen::Matrix<double, most_facet_nodes, 2>;

/// N_a(xi): linear, quadratic or trilinear; of facets linear, bilinear or quadratic (Lagrange, not Bernstein).
SolidValues shape_functions(SolidKind kind, const Vec3& xi);
FacetValues shape_functions(FacetKind kind, const Vec2& xi);

/// dN_a / dxi, row a.
SolidGradients shape_gradients(SolidKind kind, const Vec3& xi);
FacetGradients shape_gradients(FacetKind kind, const Vec2& xi);

/// Reference coordinates of node a.
Vec3 reference_node(SolidKind kind, int a);
Vec2 reference_node(FacetKind kind, int a);

/// The corners at the ends of an edge of a tet10 (of a tri6) with mid node 4 + edge (3 + edge).
std::array<int, 2> edge_of(SolidKind kind, int edge);
std::array<int, 2> edge_of(FacetKind kind, int edge);

/// Points of quadrature; the weights add up to the volume, or area, of the reference shape.
struct SolidPoint {
  Vec3 xi;
  double weight;
};
struct FacetPoint {
  Vec2 xi;
  double weight;
};

/// For stiffness. tet4: 1 point (degree 1). tet10: 4 points (degree 2). hex8: 2 x 2 x 2 Gauss.
std::span<const SolidPoint> stiffness_rule(SolidKind kind);
/// For int N dV, exact on curved cells, too. tet4: 4 points. tet10: 64 points (degree 5). hex8: 2 x 2 x 2 Gauss.
std::span<const SolidPoint> volume_rule(SolidKind kind);
/// For int N n dA and int x x n dA, exact on curved facets, too. tri3: 3 points (degree 2). quad4: 2 x 2 Gauss. tri6:
/// 16 points (degree 6).
std::span<const FacetPoint> area_rule(FacetKind kind);

}  // namespace reye::mesh
