#pragma once
#include "mesh/mesh.hpp"

/// Shape functions of the four kinds of cells on their reference cells: triangle (0,0) (1,0) (0,1) or square [-1, 1]^2.
namespace reye::mesh {

/// A value per node of a cell, entries beyond the nodes of the cell zero.
using NodeValues = Eigen::Matrix<double, most_cell_nodes, 1>;
/// A gradient per node of a cell, row by row.
using NodeGradients = Eigen::Matrix<double, most_cell_nodes, 2>;

/// N_a(xi): linear, bilinear, quadratic, or serendipity.
NodeValues shape_functions(CellKind kind, const Vec2& xi);

/// dN_a / dxi, row a.
NodeGradients shape_gradients(CellKind kind, const Vec2& xi);

/// Reference coordinates of node a.
Vec2 reference_node(CellKind kind, int a);

}  // namespace reye::mesh
