#pragma once
#include <array>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"
#include "mesh/facet.hpp"
#include "mesh/mesh.hpp"

namespace reye::mortar {

using base::Analysis;
using base::Points;
using base::Vec2;

using mesh::LineFacet;

/// One side of a contact as a line on X: straight facets, or quadratic Bezier curves x = (1-t)^2 a + 2t(1-t) c + t^2 b
/// with nodes a, b and a control point c = 2 x(1/2) - (a + b) / 2. All nodal quantities are coefficients of the
/// facet's shape functions: hats, or Bernstein polynomials. Facets run with the body on the left, so that the outward
/// normal is the tangent turned by -90 degrees.
struct Surface {
  Points X;  ///< nodes and control points on X [mm]
  std::vector<LineFacet> facets;
  int order = 1;                   ///< 2 when some facet has a control point
  std::vector<int> before, after;  ///< per node: the facet that ends / starts there, or -1; a control point: its own
  std::vector<char> corner;        ///< per node: the surface turns by more than 50 degrees there
  std::vector<double> area;        ///< per node: A_j = int N_j over all its facets [mm], 2 pi r weighted

  int node_count() const { return static_cast<int>(X.size()); }
  int facet_count() const { return static_cast<int>(facets.size()); }
  bool is_control_point(int node) const { return before[node] >= 0 && facets[before[node]][2] == node; }
  /// The node that the tangent at the first (end 0) or last node of a facet runs to.
  int beside(int facet, int end) const { return facets[facet][2] >= 0 ? facets[facet][2] : facets[facet][1 - end]; }
};

/// The surface made of chains given in node numbers of a mesh; with order 2 every second node of a chain is the middle
/// node of an edge. `nodes` receives the mesh node of each surface node, in the order of mesh::nodes_of(boundary).
Surface make_surface(const Points& X, const mesh::Boundary& boundary, Analysis analysis, std::vector<int>& nodes,
                     int order = 1);

/// Joins several surfaces into one list of nodes and facets (the primary side may be several boundaries).
Surface joined(const std::vector<Surface>& surfaces);

}  // namespace reye::mortar
