#pragma once
#include "adapt/transfer/gauss_points.hpp"

/// L2 projection of Gauss-point fields over the intersected meshes.
namespace reye::adapt {

/// One mesh of a projection.
struct GaussMesh {
  const mesh::Mesh& mesh;
  const GaussPoints& points;
};

/// In each old cell the field is the affine function f closest to its Gauss values with their volumes as weights (its
/// mean where a cell has fewer than three points); in each new cell p is the affine function (constant) with
///   sum over overlaps of int (p - f) q (2 pi r) dA = 0   for all affine (constant) q,                           (1)
/// and the new Gauss values are those of p. With V_g the volume of a Gauss point, sum_g V_g v_g is kept in every
/// component, to round-off, where both meshes cover the same domain with straight edges.
/// A new cell that is covered by half and more takes p of its covered part; with less its points take f in the old
/// cell nearest to them. Columns named in `nonnegative`, with no negative value in the old field, get none: slopes of f
/// and p are scaled about the mean until f >= 0 on the old cell and p >= 0 at the new points, which keeps the sum.
base::Matrix project(const GaussMesh& from, const base::Matrix& values, const GaussMesh& to, base::Analysis analysis,
                     const std::vector<int>& nonnegative);

}  // namespace reye::adapt
