#pragma once
#include <array>

#include "mesh/mesh.hpp"

namespace reye::body {

/// An edge of second order on a contact boundary: first, last and mid node. Contact sees it as a Bezier curve with the
/// control point c = 2 x_mid - (x_1 + x_2) / 2, so that u_mid = (u_1 + u_2) / 4 + u_c / 2.   (7)
using CurvedEdge = std::array<int, 3>;

/// The curved edges of the named boundaries, in mesh nodes; none in a mesh of first order.
std::vector<CurvedEdge> curved_edges(const mesh::Mesh& mesh, const std::vector<std::string>& boundaries);

/// Positions or displacements, at mid nodes replaced by those of the control points.
base::Points with_control_points(base::Points values, const std::vector<CurvedEdge>& edges);

}  // namespace reye::body
