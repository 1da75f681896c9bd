#pragma once
#include <array>
#include <map>
#include <vector>

#include "base/issue.hpp"
#include "body/solid/solid_input.hpp"

/// Where the supports of a solid act, and what they ask of each node.
namespace reye::body {

/// Motions of a `SolidSupport` in the order of `Driven::motion`.
inline constexpr std::array solid_motion_names{"x", "y", "z", "rotation_x", "rotation_y", "rotation_z", "normal"};
inline constexpr int normal_motion = 6;

/// The motion of a support with that number: 0 to 2 along, 3 to 5 about, 6 normal.
const Motion& motion_of(const SolidSupport& support, int m);

/// A support resolved on a mesh; with an empty face it has the whole skin.
struct SolidPlace {
  std::vector<mesh::Facet> facets;
  std::vector<int> nodes;  ///< ascending
  base::Vec3 centre;       ///< about which it turns
};
SolidPlace place_support(const mesh::SolidMesh& mesh, const SolidSupport& support);

/// The facets of all contact faces.
std::vector<mesh::Facet> contact_facets(const SolidInput& input);

/// Where the points of all nodes are: the nodes, or Bernstein control points on tri6 facets of contact faces.
Points3 contact_points(const SolidInput& input);

/// A direction along which a support holds or moves a node.
struct SolidDemand {
  int support = -1, motion = 0;
  base::Vec3 direction = base::Vec3::Zero();
};

/// What supports ask of one node. A node of a rigid face moves with it wholly.
struct NodeDemands {
  std::vector<int> rigid;            ///< supports; the first one has the node
  std::vector<SolidDemand> by_node;  ///< in the order of supports; of a rigid body, too
};
std::map<int, NodeDemands> node_demands(const SolidInput& input, const std::vector<SolidPlace>& places);

/// Which of some directions are independent, taken in turn: an angle below 1e-3 to the span of those before is none.
std::vector<int> independent(const std::vector<SolidDemand>& demands);

/// d^i with d^i . d_j = delta_ij in the span of up to three independent directions d (columns): u = sum_i d^i (d_i .
/// u).
Matrix dual_directions(const Matrix& d);

/// Unit directions orthogonal to some (columns, independent) and to each other; along axes where that is possible.
Matrix orthogonal_directions(const Matrix& d);

/// Issues of names that the mesh does not have, or of a face that is not named; keys "support.<name>.face" ...
std::vector<base::Issue> place_issues(const SolidInput& input);

}  // namespace reye::body
