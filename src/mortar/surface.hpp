#pragma once
#include <array>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"
#include "mesh/mesh.hpp"

namespace reye::mortar {

using base::Analysis;
using base::Points;
using base::Vec2;

/// One side of a contact as a polyline on X. Facets run with the body on the left, so that the outward
/// normal is the tangent turned by -90 degrees.
struct Surface {
  Points X;                                ///< node positions on X [mm]
  std::vector<std::array<int, 2>> facets;  ///< node pairs
  std::vector<int> before, after;          ///< per node: the facet that ends / starts there, or -1
  std::vector<char> corner;                ///< per node: the surface turns by more than 50 degrees there
  std::vector<double> area;                ///< per node: A_j = int N_j over all its facets [mm], 2 pi r weighted

  int node_count() const { return static_cast<int>(X.size()); }
  int facet_count() const { return static_cast<int>(facets.size()); }
};

/// The surface made of chains given in node numbers of a mesh; `nodes` receives the mesh node of each
/// surface node, in the order of mesh::nodes_of(boundary).
Surface make_surface(const Points& X, const mesh::Boundary& boundary, Analysis analysis, std::vector<int>& nodes);

/// Joins several surfaces into one list of nodes and facets (the primary side may be several boundaries).
Surface joined(const std::vector<Surface>& surfaces);

}  // namespace reye::mortar
