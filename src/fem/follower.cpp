#include "fem/follower.hpp"

#include <cmath>
#include <numbers>

namespace reye::fem {

using base::Vec2;
using base::Vector;

namespace {

/// Gauss points on [-1, 1] and their weights, exact to degree 5: N dx/dxi r of a quadratic edge.
const std::array<std::array<double, 2>, 3> rule{
    {{-std::sqrt(0.6), 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {std::sqrt(0.6), 5.0 / 9.0}}};

/// Shape functions of an edge with two or three nodes (first, mid, last) and their derivatives.
struct EdgeShape {
  std::array<double, 3> N{}, slope{};
};

EdgeShape edge_shape(int nodes, double xi) {
  if (nodes == 2) return {{0.5 * (1.0 - xi), 0.5 * (1.0 + xi)}, {-0.5, 0.5}};
  return {{0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)}, {xi - 0.5, -2.0 * xi, xi + 0.5}};
}

/// Calls visit(shape, weight of dxi, x, dx/dxi) at the Gauss points of the loaded part of an edge.
template <class Visit>
void for_each_point(const mesh::Mesh& mesh, const Vector& u, const LoadedEdge& edge, Visit visit) {
  for (const auto& [point, share] : rule) {
    const double half = 0.5 * (edge.to - edge.from);
    const EdgeShape s = edge_shape(edge.count, 0.5 * (edge.from + edge.to) + half * point);
    Vec2 x = Vec2::Zero(), tangent = Vec2::Zero();
    for (int a = 0; a < edge.count; ++a) {
      const Vec2 at = mesh.X[edge.nodes[a]] + u.segment<2>(2 * edge.nodes[a]);
      x += s.N[a] * at;
      tangent += s.slope[a] * at;
    }
    visit(s, half * share, x, tangent);
  }
}

}  // namespace

FollowerPressure::FollowerPressure(const mesh::Mesh& mesh, base::Analysis analysis, const BoundaryLoad& load)
    : analysis_(analysis), pressure_(load.pressure_MPa), edges_(loaded_edges(mesh, load)) {}

void FollowerPressure::add_force(double factor, const mesh::Mesh& mesh, const Vector& u, Vector& f) const {
  for (const LoadedEdge& edge : edges_)
    for_each_point(mesh, u, edge, [&](const EdgeShape& s, double weight, const Vec2& x, const Vec2& tangent) {
      const double p = -factor * pressure_ * weight * base::out_of_plane(analysis_, x.x());
      for (int a = 0; a < edge.count; ++a) f.segment<2>(2 * edge.nodes[a]) += p * s.N[a] * base::right_of(tangent);
    });
}

void FollowerPressure::add_tangent(double factor, const mesh::Mesh& mesh, const Vector& u, const Pattern& pattern,
                                   base::SparseMatrix& K) const {
  const double around = analysis_ == base::Analysis::axisymmetric ? 2.0 * std::numbers::pi : 0.0;  // d(2 pi r)/dr
  const Eigen::Matrix2d turn{{0.0, 1.0}, {-1.0, 0.0}};                                              // right_of
  for (const LoadedEdge& edge : edges_)
    for_each_point(mesh, u, edge, [&](const EdgeShape& s, double weight, const Vec2& x, const Vec2& tangent) {
      const double p = -factor * pressure_ * weight, ring = base::out_of_plane(analysis_, x.x());
      for (int a = 0; a < edge.count; ++a)
        for (int b = 0; b < edge.count; ++b) {
          Eigen::Matrix2d block = ring * s.slope[b] * turn;
          block.col(0) += around * s.N[b] * base::right_of(tangent);
          pattern.add(edge.nodes[a], edge.nodes[b], Eigen::Matrix2d(p * s.N[a] * block), K);
        }
    });
}

}  // namespace reye::fem
