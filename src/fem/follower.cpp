#include "fem/follower.hpp"

#include <Eigen/Core>
#include <numbers>

namespace reye::fem {

using base::Vec2;
using base::Vector;

namespace {

/// Calls visit(edge, point, x, dx/dxi) at the Gauss points of all edges, on x = X + u.
template <class Visit>
void for_each_point(const mesh::Mesh& mesh, const Vector& u, const std::vector<LoadedEdge>& edges, Visit visit) {
  for (const LoadedEdge& edge : edges)
    for (const EdgePoint& point : edge_points(edge)) {
      const auto here = on_edge(edge, point, [&](int node) { return Vec2(mesh.X[node] + u.segment<2>(2 * node)); });
      visit(edge, point, here.x, here.tangent);
    }
}

}  // namespace

FollowerPressure::FollowerPressure(const mesh::Mesh& mesh, base::Analysis analysis, const BoundaryLoad& load)
    : analysis_(analysis), pressure_(load.pressure_MPa), edges_(loaded_edges(mesh, load)) {}

void FollowerPressure::add_force(double factor, const mesh::Mesh& mesh, const Vector& u, Vector& f) const {
  for_each_point(mesh, u, edges_, [&](const LoadedEdge& edge, const EdgePoint& at, const Vec2& x, const Vec2& tangent) {
    const double p = -factor * pressure_ * at.weight * base::out_of_plane(analysis_, x.x());
    for (int a = 0; a < edge.count; ++a) f.segment<2>(2 * edge.nodes[a]) += p * at.N[a] * base::right_of(tangent);
  });
}

void FollowerPressure::add_tangent(double factor, const mesh::Mesh& mesh, const Vector& u, const Pattern& pattern,
                                   base::SparseMatrix& K) const {
  const double around = analysis_ == base::Analysis::axisymmetric ? 2.0 * std::numbers::pi : 0.0;  // d(2 pi r)/dr
  const Eigen::Matrix2d turn{{0.0, 1.0}, {-1.0, 0.0}};                                             // right_of
  for_each_point(mesh, u, edges_, [&](const LoadedEdge& edge, const EdgePoint& at, const Vec2& x, const Vec2& tangent) {
    const double p = -factor * pressure_ * at.weight, ring = base::out_of_plane(analysis_, x.x());
    for (int a = 0; a < edge.count; ++a)
      for (int b = 0; b < edge.count; ++b) {
        Eigen::Matrix2d block = ring * at.slope[b] * turn;
        block.col(0) += around * at.N[b] * base::right_of(tangent);
        pattern.add(edge.nodes[a], edge.nodes[b], Eigen::Matrix2d(p * at.N[a] * block), K);
      }
  });
}

}  // namespace reye::fem
