#pragma once
#include <vector>

#include "body/supports.hpp"
#include "mesh/mesh.hpp"

/// Where a support acts: its nodes, directions and centre on X.
namespace reye::body {

/// Whether the support moves as a rigid line: on an edge when a rotation is named or a motion is loaded, or
/// where `rigid` says so. A support at a point is never rigid.
bool is_rigid(const Support& support);

/// A support resolved on a mesh.
struct SupportPlace {
  bool rigid = false;
  std::vector<int> nodes;
  std::vector<base::Vec2> x_axis;  ///< per node; equal entries unless `edge_axes` on a curved edge
  std::vector<base::Vec2> y_axis;
  base::Vec2 centre{0.0, 0.0};  ///< arc-length centroid of the edge, or the node of a point

  bool straight() const;  ///< all nodes share the same axes
};

/// Axes: x, y turned by the support's angle; with `edge_axes` the tangent (body on the left) and the outward
/// normal, at a node the mean over its facets, for a rigid edge the mean over the whole edge at every node.
/// Throws base::InputError: unknown edge, neither edge nor point, rotation at a point.
SupportPlace place_support(const mesh::Mesh& mesh, const Support& support);

/// Whether nodes held one by one along d hold the rotation of a rigid body, too: unless d . (e_3 x X) is the same for
/// all.
bool holds_rotation(const mesh::Mesh& mesh, const Support& support, const SupportPlace& place);

}  // namespace reye::body
