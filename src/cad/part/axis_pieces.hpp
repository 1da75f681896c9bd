#pragma once
#include <vector>

#include "cad/part/part.hpp"

/// Outlines that pass through the axis x = 0 of a solid of revolution.
namespace reye::cad {

/// A piece of an edge that lies on one side of the axis: 1 at x > 0, -1 at x < 0, 0 along it.
struct AxisPiece {
  Edge edge;
  int side = 0;
};

/// Distance below which a point lies on the axis, as CAD rounds zero in a part of this extent [mm].
double axis_width(const Part& part);

/// Diagonal of the bounding box [mm].
double extent(const Part& part);

/// The pieces of an edge between its crossings of the axis; their ends on the axis lie exactly on it.
std::vector<AxisPiece> axis_pieces(const Edge& edge, double width);

/// Whether some of the outline lies at x > 0 and some at x < 0.
bool crosses_axis(const Part& part);

}  // namespace reye::cad
