#include "adapt/shape/unworn.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "adapt/shape/fit.hpp"
#include "adapt/shape/runs.hpp"

namespace reye::adapt {

namespace {

double turning(const base::Vec2& in, const base::Vec2& out) {
  return std::abs(std::atan2(base::cross(in, out), in.dot(out)));
}

/// A smooth piece between two corners; where the nodes do not form a smooth curve, their polyline.
cad::Edge piece(Points points) {
  constexpr double of_mean_facet = 0.05;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  const double tolerance = of_mean_facet * length / static_cast<double>(points.size() - 1);
  return fit(cad::EdgeType::spline, std::move(points), tolerance);
}

}  // namespace

UnwornLine::UnwornLine(const mesh::Mesh& mesh, const mesh::Boundary& boundary) {
  for (const auto& chain : boundary) {
    Points points{mesh.X[chain.front()]};
    for (std::size_t k = 1; k < chain.size(); ++k) {
      points.push_back(mesh.X[chain[k]]);
      const bool last = k + 1 == chain.size();
      const auto& x = mesh.X[chain[k]];
      if (!last && turning(x - mesh.X[chain[k - 1]], mesh.X[chain[k + 1]] - x) <= drawn_kink) continue;
      edges_.push_back(piece(std::exchange(points, {x})));
    }
  }
}

double UnwornLine::depth(const base::Vec2& x) const {
  double nearest = std::numeric_limits<double>::infinity(), depth = 0.0;
  for (const auto& edge : edges_) {
    const auto foot = cad::foot_on(edge, x);
    if (foot.distance >= nearest) continue;
    nearest = foot.distance;
    depth = base::right_of(cad::tangent_at(edge, foot.s)).dot(cad::at(edge, foot.s) - x);
  }
  return depth;
}

}  // namespace reye::adapt
