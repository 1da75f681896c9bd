#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

/// Origin and direction of arc length along a boundary.
namespace reye::mesh {

/// A chain as tables and loads count it: nodes from the origin of its arc length on. A ring begins and ends at its
/// origin and runs with the body on its left.
struct ArcChain {
  Chain nodes;
  std::vector<double> arc;  ///< of each node from the origin [mm]
  bool along = true;        ///< the nodes run as the boundary's chain does, with the body on the left
};

/// The chains of a boundary in the order of arc length, each counted from zero. `mesh.arc_origin` says where each
/// begins; without an entry, an open chain counts from its end with the smaller x (ties: smaller y), a ring from
/// its first node, and the chains follow one another by the x of their origins.
std::vector<ArcChain> arc_chains(const Mesh& mesh, const std::string& boundary);

/// The nodes at which the arc chains of a boundary begin.
std::vector<int> arc_origins(const Mesh& mesh, const std::string& boundary);

/// Takes the origins of arc length from the mesh that a mesh replaces: the end of each chain, or the vertex of a ring,
/// that lies nearest to the former origin.
void follow_arc_origins(Mesh& mesh, const Mesh& former);

/// The arc length in the middle of the longest stretch between at least one given place on a ring, all in [0, length].
double amid_longest_gap(std::vector<double> arcs, double length);

/// The vertex of a ring farthest along it from at least one point: in the middle of the longest stretch between the
/// vertices nearest to the points; for a single point half of the ring's length away.
int farthest_from(const Mesh& mesh, const Chain& ring, const Points& points);

}  // namespace reye::mesh
