#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "base/analysis.hpp"
#include "mesh/mesh.hpp"
#include "mesh/shape.hpp"

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

/// tri3: 1 point (degree 1). tri6: 3 points (degree 2). quad4 and quad8: 2 x 2 Gauss (degree 3 in each direction), for
/// quad8 the reduced rule, whose spurious mode neighbouring cells cannot share.
std::span<const CellPoint> stiffness_rule(mesh::CellKind kind);
/// tri3: 3 points (degree 2), so that N b 2 pi r is exact. tri6: 7 points (degree 5). quad4: 2 x 2 Gauss. quad8: 3 x 3
/// Gauss (degree 5 in each direction).
std::span<const CellPoint> volume_rule(mesh::CellKind kind);

using mesh::NodeGradients;
using mesh::NodeValues;
using mesh::shape_functions;
using mesh::shape_gradients;

/// A point of `stiffness_rule` with the shape functions there, which are the same for all cells of a kind.
struct RulePoint {
  CellPoint at;
  NodeValues N;
  NodeGradients dN_dxi;
};
std::span<const RulePoint> tabulated_rule(mesh::CellKind kind);
/// The centre of a quad4 with its shape functions, weight 1.
const RulePoint& centre_of_quad4();

/// Strain operator at a quadrature point of a cell with n nodes (4 in first order, 8 in second):
///   (eps_11, eps_22, gamma_12, eps_33) = B (u_1x, u_1y, u_2x, ...),  eps_33 = u_r / r (axisymmetric) or 0.
/// Columns of nodes that a triangle does not have are zero. With B-bar the volumetric part is its cell mean,
///   B-bar = B + 1/3 m (b_mean - b),  b = m^T B,  m = (1, 1, 0, 1),          (1)
/// so that in plane strain eps_33 of a single point need not vanish (its mean does).
template <int n>
struct StrainPoint {
  Eigen::Matrix<double, 4, 2 * n> B;
  double volume = 0.0;  ///< weight * det J * (1 or 2 pi r) [mm^2 or mm^3]
};

/// The strain points of one cell, at most four.
template <int n>
struct CellStrains {
  std::array<StrainPoint<n>, 4> points;
  int count = 0;
};

/// n = 4 or 8. `b_bar` acts on quad4 in plane strain and axisymmetry; elsewhere it is ignored: a tri3 is its own mean,
/// reduced integration keeps quad8 from locking, and plane stress does not lock. Throws base::MeshError naming the cell
/// when a Jacobian is not positive.
template <int n>
CellStrains<n> strain_points(const Mesh& mesh, int cell, Analysis analysis, bool b_bar);

/// Point of a cell for volume integrals: N_a and weight * det J * (1 or 2 pi r).
struct VolumePoint {
  NodeValues N;
  double volume;
};
std::vector<VolumePoint> volume_points(const Mesh& mesh, int cell, Analysis analysis);

}  // namespace reye::fem
