#pragma once
#include <string>
#include <vector>

#include "body/operator.hpp"
#include "mesh/mesh.hpp"

/// Supports of one body that ask different things of one place.
namespace reye::body {

/// What one support asks for and does not get.
struct SupportConflict {
  int support = 0;      ///< of `BodyInput::supports`
  std::string motion;   ///< "x", "y", "rotation", or empty: the whole support
  std::string text;     ///< who else is there and what to change
  bool refused = true;  ///< false: all else of the support acts, so that the body can be solved as it is
};

/// All of a deformable body: a node on two rigid edges; a node-wise support against a rigid edge; more than two
/// directions held in a node, or one twice, with different values; the axis of symmetry moved along x; an edge turned
/// in axisymmetry. What agrees in value (two supports that fix the same direction) is no conflict. One per pair of
/// supports.
std::vector<SupportConflict> support_conflicts(const mesh::Mesh& mesh, const BodyInput& input);

/// All of a rigid body: one motion driven by two supports to different values; a rotation that an edge held node by
/// node does not allow; in axisymmetry anything but the motion along the axis.
std::vector<SupportConflict> rigid_support_conflicts(const mesh::Mesh& mesh, const BodyInput& input);

}  // namespace reye::body
