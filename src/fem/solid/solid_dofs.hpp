#pragma once
#include <array>
#include <vector>

#include "base/linalg.hpp"
#include "base/space.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::fem {

using base::Mat3;
using base::Points3;
using base::Vec3;

/// A share of a node in a dof that several nodes have in common.
struct SharedTerm {
  int dof;  ///< counted from the first shared one
  Vec3 direction;
};

/// A node whose point does not simply move by three dofs of its own.
struct SpecialNode {
  Mat3 basis = Mat3::Zero();  ///< its first columns: directions of the node's own dofs
  std::vector<SharedTerm> shared;
};

/// The independent dofs y of a solid, u = T y: own dofs of single nodes first, then those that nodes share. The point
/// of a node moves by
///   p = basis y_own + sum over shared terms of direction y_shared,
/// and is the node itself, u = p, or the Bernstein control point of a mid node between nodes 1 and 2,
///   u = p / 2 + (p_1 + p_2) / 4.
struct SolidDofs {
  int own = 0, shared = 0;
  std::vector<int> first;                   ///< per node: its first own dof; distinct where `count` > 0
  std::vector<int> count;                   ///< per node: its own dofs, 0 to 3
  std::vector<int> special;                 ///< per node: of `nodes`, or -1: basis = identity, nothing shared
  std::vector<std::array<int, 2>> between;  ///< per node: nodes 1 and 2 of a control point, or -1
  std::vector<SpecialNode> nodes;

  int size() const { return own + shared; }
};

/// Three dofs for each node, dof = 3 * node + component.
SolidDofs plain_dofs(int nodes);

/// T, 3n x dofs.size(), row = 3 * node + component.
base::SparseMatrix expansion(const SolidDofs& dofs);

}  // namespace reye::fem
