#pragma once
#include "adapt/transfer/gauss_points.hpp"

/// Nodal values from Gauss values.
namespace reye::adapt {

/// Patch recovery (Zienkiewicz & Zhu 1992) with affine polynomials: the value at a node is that of the affine function
/// closest to the values at the n Gauss points of the cells around it,
///   v(X) = sum_i w_i v_i,   w_i = 1/n + d_i . S^-1 (X - mean x),   d_i = x_i - mean x,   S = sum d_i d_i^T.   (1)
/// The patch grows by one ring of cells until |w|^2 = 1/n + (X - mean x) . S^-1 (X - mean x) <= 1, so that recovery
/// never amplifies noise, at corners and beside single cells too; this does not change under affine maps.
/// values: one row per Gauss point; result: one row per node. A mesh whose points lie on one line gives the mean.
base::Matrix at_nodes(const mesh::Mesh& mesh, const GaussPoints& points, const base::Matrix& values);

}  // namespace reye::adapt
