#pragma once
#include <string>
#include <vector>

#include "mortar/surface.hpp"

/// Fields carried from one boundary to the same boundary remeshed.
namespace reye::adapt {

/// Kind of a nodal value of a surface, which decides how it is carried (README, 6).
enum class SurfaceKind {
  interpolated,  ///< value at a point: linear along the old polyline, quadratic along curved facets
  summed,        ///< nodal share of an integral: its density is interpolated, its sum kept
  nearest        ///< label: that of the nearest old node
};

/// values: one per node of the surface; at control points the coefficient of their Bernstein function.
struct SurfaceField {
  std::string name;
  SurfaceKind kind = SurfaceKind::interpolated;
  std::vector<double> values;
};

struct SurfaceTransfer {
  std::vector<SurfaceField> fields;
  double largest_distance = 0.0;  ///< of a new node from the old polyline [mm]; 0 without fields
};

/// The fields of `from` on the nodes of `to`, both made of the same named boundary of the old and the new mesh, each
/// with at least one facet. A new node, or the middle of the curve of a new control point, belongs to the closest point
/// of the old line; of facets that are equally near to round-off, one that runs in its own direction. A new control
/// point gets the coefficient that gives the correct value in the middle. Identical surfaces: identical values to
/// round-off.
SurfaceTransfer carry(const mortar::Surface& from, const std::vector<SurfaceField>& fields, const mortar::Surface& to);

}  // namespace reye::adapt
