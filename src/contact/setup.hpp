#pragma once
#include <vector>

#include "body/operator.hpp"
#include "contact/options.hpp"
#include "contact/state.hpp"
#include "mortar/surface.hpp"

namespace reye::contact {

/// The body and contact node of a surface node.
struct SurfaceNode {
  int body = 0;
  int mesh_node = 0;
  body::ContactIndex contact_node{};
};

/// A contact on its present shapes: derived from them, renewed when one of them changes.
struct Setup {
  ContactOptions options;
  base::Analysis analysis = base::Analysis::plane_strain;
  base::Kinematics measure = base::Kinematics::small;  ///< strain measure of the secondary body
  mortar::Surface secondary, primary;
  std::vector<SurfaceNode> secondary_nodes, primary_nodes;
  std::vector<char> cut;                   ///< secondary nodes that carry no multiplier
  std::vector<body::NodeFreedom> freedom;  ///< of secondary nodes
  std::vector<double> length;              ///< per secondary node: of a facet, the mean of those beside it [mm]
  std::vector<double> stiffness;           ///< c_n = c_t per secondary node: E / h [MPa/mm]
  double search = 0.0;
  /// Traction that counts as zero [MPa]: 1e-30 of the pair's modulus, far below the rounding error of any other. Bodies
  /// at rest without load have such tractions, and neither sign nor status follows from them.
  double faint = 0.0;

  int secondary_count() const { return secondary.node_count(); }
  int primary_count() const { return primary.node_count(); }
  /// A control point without multiplier: it wears as the mean of the two nodes beside it.
  bool between(int node) const { return cut[node] && secondary.is_control_point(node); }
};

/// A boundary of the scene and its body.
struct BoundaryRef {
  int body = 0;
  std::string boundary;
};

/// Builds the two surfaces. `modulus_MPa` scales the complementarity factors; `measure` is that of the secondary body.
Setup make_setup(const ContactOptions& options, base::Analysis analysis, const BoundaryRef& secondary,
                 const std::vector<BoundaryRef>& primary, const std::vector<body::ShapePtr>& shapes,
                 const std::vector<body::Operator>& operators, double modulus_MPa,
                 base::Kinematics measure = base::Kinematics::small);

/// A contact before anything has happened.
ContactState fresh_state(const Setup& setup);

}  // namespace reye::contact
