#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "base/analysis.hpp"
#include "mesh/mesh.hpp"

/// One cell: shape functions, quadrature and strain operators.
namespace reye::fem {

using base::Analysis;
using base::Vec2;
using mesh::Mesh;

/// Quadrature point of a reference cell: triangle (0,0) (1,0) (0,1) or square [-1, 1]^2.
struct CellPoint {
  Vec2 xi;
  double weight;
};

/// Triangle: 1 point (degree 1). Square: 2 x 2 Gauss (degree 3 in each direction).
std::span<const CellPoint> stiffness_rule(mesh::CellKind kind);
/// Triangle: 3 points (degree 2), so that N b 2 pi r is exact. Square: 2 x 2 Gauss.
std::span<const CellPoint> volume_rule(mesh::CellKind kind);

/// Shape functions N_a(xi), entries beyond the nodes of the cell zero.
Eigen::Vector4d shape_functions(mesh::CellKind kind, const Vec2& xi);
/// dN_a/dxi, row a.
Eigen::Matrix<double, 4, 2> shape_gradients(mesh::CellKind kind, const Vec2& xi);

/// Strain operator of a cell at a quadrature point:
///   (eps_11, eps_22, gamma_12, eps_33) = B (u_1x, u_1y, u_2x, ...),  eps_33 = u_r / r (axisymmetric) or 0.
/// A triangle leaves the last two columns zero. With B-bar the volumetric part is its cell mean,
///   B-bar = B + 1/3 m (b_mean - b),  b = m^T B,  m = (1, 1, 0, 1),          (1)
/// so that in plane strain eps_33 of a single point need not vanish (its mean does).
struct StrainPoint {
  Eigen::Matrix<double, 4, 8> B;
  double volume = 0.0;  ///< weight * det J * (1 or 2 pi r) [mm^2 or mm^3]
};

/// The strain points of one cell, at most four.
struct CellStrains {
  std::array<StrainPoint, 4> points;
  int count = 0;
};

/// `b_bar` acts on quadrilaterals in plane strain and axisymmetry; elsewhere it is ignored: a triangle is its own
/// mean, and plane stress does not lock. Throws base::MeshError naming the cell when a Jacobian is not positive.
CellStrains strain_points(const Mesh& mesh, int cell, Analysis analysis, bool b_bar);

/// Point of a cell for volume integrals: N_a and weight * det J * (1 or 2 pi r).
struct VolumePoint {
  Eigen::Vector4d N;
  double volume;
};
std::vector<VolumePoint> volume_points(const Mesh& mesh, int cell, Analysis analysis);

}  // namespace reye::fem
