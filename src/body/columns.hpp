#pragma once
#include <array>
#include <vector>

#include "body/operator.hpp"
#include "mesh/mesh.hpp"

/// The unknowns of a linear body: which columns move which node.
namespace reye::body {

/// u_full = B y,  y = [free dofs of nodes not in contact; q],  q = [free dofs of contact nodes; support columns].
struct Columns {
  int interior = 0;
  int retained = 0;
  std::vector<std::vector<Term>> terms;   ///< per node: u = sum y[column] * direction (columns of y, not of q)
  std::vector<NodeFreedom> freedom;       ///< per node
  std::vector<int> contact_nodes;
  std::vector<SupportColumn> supports;    ///< columns of q

  base::SparseMatrix expansion() const;   ///< B, 2n x (interior + retained)
};

/// Who wins where several supports meet in a node: the axis of symmetry (r = 0 held in x, no column), then the
/// first rigid edge (the node belongs to it wholly), then node-wise supports in the order given: the first two
/// independent directions are held, a third one or a nearly parallel one (angle below 1e-3) is left out.
/// With two held directions d1, d2 the node solves for both: u = [d1^T; d2^T]^-1 (U1, U2).   (2)
/// A column that no node ends up using is dropped.
Columns number_columns(const mesh::Mesh& mesh, const BodyInput& input);

}  // namespace reye::body
