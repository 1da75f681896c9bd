#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

/// From where arc length counts along a boundary, and which way.
namespace reye::mesh {

/// A chain as tables and loads count it: nodes from the origin of its arc length on. A ring begins and ends at its
/// origin and runs with the body on its left.
struct ArcChain {
  Chain nodes;
  std::vector<double> arc;  ///< of each node from the origin [mm]
  bool along = true;        ///< the nodes run as the boundary's chain does, with the body on the left
};

/// The chains of a boundary in the order of arc length, each counted from zero. `mesh.arc_origin` says where each
/// begins; where it says nothing, an open chain counts from its end with the smaller x (ties: smaller y), a ring from
/// its first node, and the chains follow one another by the x of their origins.
std::vector<ArcChain> arc_chains(const Mesh& mesh, const std::string& boundary);

/// The nodes at which those chains begin.
std::vector<int> arc_origins(const Mesh& mesh, const std::string& boundary);

/// Lets the boundaries of a mesh count as those of the mesh that it replaces: of each chain the end, of a ring the
/// vertex, that lies nearest to where the former one began.
void follow_arc_origins(Mesh& mesh, const Mesh& former);

/// The arc length on a ring of some length amid the longest stretch between places on it, at least one, all in [0,
/// length].
double amid_longest_gap(std::vector<double> arcs, double length);

/// The vertex of a ring that lies farthest along it from some points, at least one: amid the longest stretch between
/// the vertices nearest to them; of a single one opposite, half of the ring's length away.
int farthest_from(const Mesh& mesh, const Chain& ring, const Points& points);

}  // namespace reye::mesh
