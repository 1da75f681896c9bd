#pragma once
#include <string>
#include <vector>

#include "body/operator.hpp"
#include "mesh/mesh.hpp"

/// Supports of one body that contradict each other in one place.
namespace reye::body {

/// A motion that one support prescribes and cannot have.
struct SupportConflict {
  int support = 0;      ///< of `BodyInput::supports`
  std::string motion;   ///< "x", "y", "rotation", or empty: the whole support
  std::string text;     ///< the other support and what to change
  bool refused = true;  ///< false: the rest of the support acts, so that the body can be solved as it is
};

/// All conflicts of a deformable body: a node on two rigid edges; a node-wise support against a rigid edge; more than
/// two directions held in a node, or one twice, with different values; the axis of symmetry moved along x; an edge
/// turned in axisymmetry. Equal values (two supports that fix the same direction) are not a conflict. One conflict per
/// pair of supports.
std::vector<SupportConflict> support_conflicts(const mesh::Mesh& mesh, const BodyInput& input);

/// All conflicts of a rigid body: one motion driven by two supports to different values; a rotation that an edge held
/// node by node does not allow; in axisymmetry anything but the motion along the axis.
std::vector<SupportConflict> rigid_support_conflicts(const mesh::Mesh& mesh, const BodyInput& input);

}  // namespace reye::body
