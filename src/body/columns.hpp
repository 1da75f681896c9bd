#pragma once
#include <array>
#include <vector>

#include "body/operator.hpp"
#include "mesh/mesh.hpp"

/// The unknowns of a body: which columns move which node.
namespace reye::body {

/// Sine below which two held directions count as one.
constexpr double parallel = 1e-3;

/// The motion that one term gives its node, with its first and second derivative.
struct Path {
  base::Vec2 displacement{0.0, 0.0}, slope{0.0, 0.0}, curvature{0.0, 0.0};
};

/// A node of a contact boundary as contact sees it: the node, or the control point in place of a mid node.
struct ContactNode {
  base::Vec2 X;
  std::vector<Term> terms;  ///< its own columns, of y
  NodeFreedom freedom;
};

/// u_full = B y,  y = [free dofs of nodes not in contact; q],  q = [free dofs of contact nodes; support columns].
struct Columns {
  int interior = 0;
  int retained = 0;
  std::vector<std::vector<Term>> terms;  ///< per node: u = sum y[column] * direction (columns of y, not of q)
  std::vector<int> contact_nodes;
  std::vector<ContactNode> seen;              ///< per contact node
  std::vector<mesh::LineFacet> curved_edges;  ///< on contact boundaries
  std::vector<SupportColumn> supports;        ///< columns of q

  const ContactNode& node(ContactIndex at) const { return seen[static_cast<std::size_t>(at)]; }

  base::SparseMatrix expansion() const;  ///< B, 2n x (interior + retained)
  /// The columns y of a rigid motion by one along x, and along y: all columns x 2. In axisymmetry nothing moves along
  /// the radius without strain.
  Matrix translations(base::Analysis analysis) const;

  /// Whether a column of y is the rotation of a rigid edge.
  bool turns(int column) const;
  /// A term at a value of its column: u = value d; with `true_rotation`, in a column that turns,
  ///   u = (R(theta) - I)(X - Xc) = sin theta d + (1 - cos theta) e3 x d,  d = e3 x (X - Xc).   (5)
  Path path(const Term& term, double value, bool true_rotation) const;
};

/// Sets the columns of up to two free terms so that together they displace a node by `rest`.
void set_free(const std::vector<Term>& free, const Vec2& rest, Vector& values);

/// Order of precedence where several supports meet in a node: the axis of symmetry (r = 0 held in x, no column), then
/// the first rigid edge (the node belongs to it wholly), then node-wise supports in the order given: the first two
/// independent directions are held, a third one or a nearly parallel one (angle below 1e-3) is left out.
/// With two held directions d1, d2 the node solves for both: u = [d1^T; d2^T]^-1 (U1, U2).   (2)
/// A column that no node ends up using is dropped. Throws base::InputError when a contact boundary is unknown.
/// `retained`: further nodes that are retained, after those in contact.
Columns number_columns(const mesh::Mesh& mesh, const BodyInput& input, const std::vector<int>& retained = {});

}  // namespace reye::body
