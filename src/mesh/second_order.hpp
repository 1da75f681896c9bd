#pragma once
#include "mesh/mesh.hpp"

namespace reye::mesh {

/// The mesh with a node in the middle of every edge, so that all edges stay straight. Nodes keep their numbers, mid
/// nodes follow in the order of the cells' edges. A mesh of second order is returned as it is.
Mesh to_second_order(const Mesh& mesh);

/// The mesh without its mid nodes, edges straight between its vertices, which are numbered in the order they had.
/// A mesh of first order is returned as it is.
Mesh to_first_order(const Mesh& mesh);

}  // namespace reye::mesh
