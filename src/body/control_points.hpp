#pragma once
#include "mesh/facet.hpp"
#include "mesh/mesh.hpp"

namespace reye::body {

/// The curved facets of the named boundaries, in mesh nodes; none in a mesh of first order. Contact sees them by their
/// control points, u_mid = (u_1 + u_2) / 4 + u_c / 2.   (7)
std::vector<mesh::LineFacet> curved_edges(const mesh::Mesh& mesh, const std::vector<std::string>& boundaries);

}  // namespace reye::body
