#pragma once
#include <functional>

#include "adapt/shape/shape_step.hpp"
#include "mesh/facet.hpp"
#include "mesh/quadratic_edge.hpp"

#include "support/meshes.hpp"

/// Losses of boundaries made of quadratic edges, and what bodies with such outlines contain.
namespace reye::support::curved {

using adapt::WornBoundary;
using base::Analysis;
using mesh::QuadraticEdge;
using Depth = std::function<double(Vec2)>;

inline QuadraticEdge edge_at(const Mesh& m, const Chain& chain, std::size_t i) {
  return {m.X[chain[i]], m.X[chain[i + 1]], m.X[chain[i + 2]]};
}

/// Losses that give the depth field sum B_j V_j / A_j the values depth(x) at all nodes of the boundary.
inline WornBoundary worn_by(const Mesh& m, const std::string& boundary, const Depth& depth,
                            Analysis analysis = Analysis::plane_strain) {
  std::vector<double> length(m.X.size(), 0.0), W(m.X.size(), 0.0);
  for (const auto& chain : m.boundaries.at(boundary))
    for (std::size_t i = 0; i + 2 < chain.size(); i += 2) {
      const auto edge = edge_at(m, chain, i);
      for (const auto& [xi, weight] : mesh::gauss5) {
        const double t = 0.5 * (1.0 + xi);
        const double ds = weight * edge.tangent(xi).norm() * base::out_of_plane(analysis, edge.at(xi).x());
        length[chain[i]] += (1.0 - t) * (1.0 - t) * ds;
        length[chain[i + 1]] += 2.0 * t * (1.0 - t) * ds;
        length[chain[i + 2]] += t * t * ds;
      }
      W[chain[i]] = depth(edge.first);
      W[chain[i + 2]] = depth(edge.last);
      W[chain[i + 1]] = 2.0 * depth(edge.mid) - 0.5 * (depth(edge.first) + depth(edge.last));
    }
  WornBoundary worn{boundary, {}};
  for (int node : mesh::nodes_of(m.boundaries.at(boundary))) worn.removed.push_back(length[node] * W[node]);
  return worn;
}

inline double sum(const WornBoundary& worn) {
  double total = 0.0;
  for (double v : worn.removed) total += v;
  return total;
}

/// Area, or volume of revolution, inside the quadratic edges of an outline by Green's theorem, in long double so that
/// the difference of two bodies has the digits of a strip.
inline long double content(const Mesh& m, Analysis analysis) {
  using Real = long double;
  const Real out = std::sqrt(Real(3) / Real(5));
  const Real side = Real(5) / Real(9), middle = Real(8) / Real(9);
  const std::array<std::array<Real, 2>, 3> gauss{{{-out, side}, {0.0L, middle}, {out, side}}};
  Real total = 0.0L;
  for (const auto& loop : m.outline)
    for (std::size_t i = 0; i + 2 < loop.size(); i += 2)
      for (const auto& [xi, weight] : gauss) {
        const std::array<Real, 3> N{xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2};
        const std::array<Real, 3> d{xi - Real(0.5), -2 * xi, xi + Real(0.5)};
        Real x = 0, slope = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          x += N[k] * Real(m.X[loop[i + k]].x());
          slope += d[k] * Real(m.X[loop[i + k]].y());
        }
        total += weight * slope * (analysis == Analysis::axisymmetric ? std::acos(Real(-1)) * x * x : x);
      }
  return total;
}

inline double lost(const Mesh& before, const Mesh& after, Analysis analysis = Analysis::plane_strain) {
  return static_cast<double>(content(before, analysis) - content(after, analysis));
}

}  // namespace reye::support::curved
