#pragma once
#include <cmath>
#include <functional>

#include "adapt/shape/shape_step.hpp"
#include "mesh/measure.hpp"
#include "support/meshes.hpp"

/// Losses for the tests of the shape step.
namespace reye::support {

using adapt::WornBoundary;
using base::Analysis;

inline constexpr auto plane = Analysis::plane_strain;

/// A parabolic scar.
inline auto scar(double depth, double x0, double half_width) {
  return [=](Vec2 x) { return depth * std::max(0.0, 1.0 - std::pow((x.x() - x0) / half_width, 2)); };
}

/// int N_j (2 pi r) ds over the facets of a boundary, in the order of mesh::nodes_of.
inline std::vector<double> weights(const Mesh& m, const std::string& boundary, Analysis analysis) {
  std::vector<double> by_node(m.X.size(), 0.0), result;
  for (const auto& chain : m.boundaries.at(boundary))
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      const Vec2 &a = m.X[chain[k]], &b = m.X[chain[k + 1]];
      const double length = (b - a).norm();
      for (int g : {-1, 1}) {  // two Gauss points, exact for N_j r; not the room's own formula
        const double s = 0.5 + g * 0.5 / std::sqrt(3.0);
        const double weight = 0.5 * length * base::out_of_plane(analysis, (1.0 - s) * a.x() + s * b.x());
        by_node[chain[k]] += (1.0 - s) * weight;
        by_node[chain[k + 1]] += s * weight;
      }
    }
  for (int node : mesh::nodes_of(m.boundaries.at(boundary))) result.push_back(by_node[node]);
  return result;
}

/// The loss of a boundary worn by depth(x) at each node.
inline WornBoundary worn_by(const Mesh& m, const std::string& boundary, const std::function<double(Vec2)>& depth,
                            Analysis analysis = Analysis::plane_strain) {
  WornBoundary worn{boundary, weights(m, boundary, analysis)};
  const auto nodes = mesh::nodes_of(m.boundaries.at(boundary));
  for (std::size_t k = 0; k < nodes.size(); ++k) worn.removed[k] *= depth(m.X[nodes[k]]);
  return worn;
}

inline double sum(const WornBoundary& worn) {
  double total = 0.0;
  for (double v : worn.removed) total += v;
  return total;
}

/// What a body gains when its outline loops are integrated by Green's theorem, in long double so that the
/// difference of two bodies still has the digits of a strip: area, or volume of revolution.
inline long double content(const Mesh& m, Analysis analysis) {
  long double total = 0.0L;
  const long double pi = std::acos(-1.0L);
  for (const auto& loop : m.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const long double x = m.X[loop[k]].x(), y = m.X[loop[k]].y(), u = m.X[loop[k + 1]].x(), v = m.X[loop[k + 1]].y();
      total +=
          analysis == Analysis::axisymmetric ? pi / 3.0L * (x * x + x * u + u * u) * (v - y) : (x * v - u * y) / 2.0L;
    }
  return total;
}

/// Volume lost from `before` to `after`, independent of the strips.
inline double lost(const Mesh& before, const Mesh& after, Analysis analysis = Analysis::plane_strain) {
  return static_cast<double>(content(before, analysis) - content(after, analysis));
}

}  // namespace reye::support
