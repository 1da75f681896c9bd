#pragma once
#include <array>
#include <vector>

#include "fem/loads.hpp"
#include "mesh/mesh.hpp"

namespace reye::fem {

/// The part of one edge of the outline that a load covers: the nodes of the edge (first, last, or first, mid, last) and
/// the covered part in the parameter of the edge, from -1 (first) to 1 (last).
struct LoadedEdge {
  std::array<int, 3> nodes{-1, -1, -1};
  int count = 2;
  double from = -1.0, to = 1.0;
};

/// All edges that a load covers, cut by its interval as `load_vector` says.
/// Throws base::InputError when the edge is unknown or the interval meets none of it.
std::vector<LoadedEdge> loaded_edges(const mesh::Mesh& mesh, const BoundaryLoad& load);

/// A Gauss point of the covered part: shape functions of its nodes, their derivatives, and the weight of dxi.
struct EdgePoint {
  std::array<double, 3> N{}, slope{};
  double weight = 0.0;
};

/// Five Gauss points: exact for N times a pressure times r, on quadratic edges too.
std::array<EdgePoint, 5> edge_points(const LoadedEdge& edge);

/// Position and dx/dxi at a point of an edge, of nodes at `position(node)`.
struct OnEdge {
  base::Vec2 x{0.0, 0.0}, tangent{0.0, 0.0};
};

template <class Position>
OnEdge on_edge(const LoadedEdge& edge, const EdgePoint& point, Position position) {
  OnEdge here;
  for (int a = 0; a < edge.count; ++a) {
    const base::Vec2 at = position(edge.nodes[a]);
    here.x += point.N[a] * at;
    here.tangent += point.slope[a] * at;
  }
  return here;
}

}  // namespace reye::fem
