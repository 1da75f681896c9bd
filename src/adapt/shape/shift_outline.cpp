#include "adapt/shape/shift_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "adapt/shape/crossing.hpp"
#include "adapt/shape/outline.hpp"
#include "adapt/shape/relocation.hpp"
#include "adapt/shape/runs.hpp"
#include "mesh/quality.hpp"

namespace reye::adapt {

namespace {

/// Steps of nodes and control points: the given part and the free part.
struct Steps {
  Points by, free;
  std::vector<LineFacet> facets;  ///< that these move
};

/// Direction of a vertex that belongs to the boundary with the facet before it, the one after it or both.
Vec2 outwards(const Points& P, const Outline& outline, int node, bool before, bool after) {
  const LineFacet first = outline.facet_before(node), second = outline.facet_after(node);
  const Vec2 in = (P[node] - P[first[2] >= 0 ? first[2] : first[0]]).normalized();
  const Vec2 out = (P[second[2] >= 0 ? second[2] : second[1]] - P[node]).normalized();
  if (before && after) return (base::right_of(in) + base::right_of(out)).normalized();
  const Vec2 normal = base::right_of(before ? in : out), side = before ? out : in;
  const double turning = std::abs(std::atan2(base::cross(in, out), in.dot(out))), along = side.dot(normal);
  constexpr double least_along = 0.2;
  return turning > least_turning && std::abs(along) > least_along ? Vec2(side / along) : normal;
}

/// The facets of the outline with one of these nodes.
std::vector<LineFacet> facets_at(const Outline& outline, const std::set<int>& nodes) {
  std::vector<WornNode> touched;
  for (int node : nodes) touched.push_back({node});
  return touched_facets(outline, touched);
}

/// The nodes that are asked to move.
std::set<int> moving(const mesh::Mesh& mesh, const std::vector<OutlineShift>& shifts) {
  std::set<int> nodes;
  for (const auto& shift : shifts) {
    const auto own = mesh::nodes_of(mesh.boundaries.at(shift.boundary));
    for (std::size_t k = 0; k < own.size(); ++k)
      if (shift.by[k] != 0.0 || shift.free[k] != 0.0) nodes.insert(own[k]);
  }
  return nodes;
}

Steps steps_of(const mesh::Mesh& mesh, const Outline& outline, const std::vector<OutlineShift>& shifts) {
  Steps steps{Points(mesh.X.size(), Vec2::Zero()), Points(mesh.X.size(), Vec2::Zero()),
              facets_at(outline, moving(mesh, shifts))};
  const Points P = mesh::control_points(steps.facets, mesh.X);
  for (const auto& shift : shifts) {
    const auto& boundary = mesh.boundaries.at(shift.boundary);
    std::map<int, std::array<bool, 2>> sides;
    for (const auto& chain : boundary)
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) sides[chain[k]][1] = sides[chain[k + 1]][0] = true;
    const auto nodes = mesh::nodes_of(boundary);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (shift.by[k] == 0.0 && shift.free[k] == 0.0) continue;
      const int node = nodes[k];
      const auto& [before, after] = sides.at(node);
      const Vec2 d = outline.middle[node]
                         ? base::right_of(P[outline.after[node]] - P[outline.before[node]]).normalized()
                         : outwards(P, outline, node, before, after);
      steps.by[node] += shift.by[k] * d;
      steps.free[node] += shift.free[k] * d;
    }
  }
  return steps;
}

/// The multiple of the free motion for which the strip has no volume, by the secant method down to round-off.
double balance(Analysis analysis, const Points& P, const Steps& steps) {
  const auto strip = [&](double times) {
    Points d = steps.by;
    for (std::size_t j = 0; j < d.size(); ++j) d[j] += times * steps.free[j];
    return strip_volume(analysis, P, steps.facets, d);
  };
  const double start = strip(0.0);
  if (start == 0.0) return 0.0;
  constexpr double small = 1e-9;
  double times = 0.0, f = start, slope = strip_volume(analysis, P, steps.facets, steps.free, small) / small;
  for (int i = 0; i < 30 && f != 0.0; ++i) {
    const double next = times - f / slope, g = strip(next);
    if (!(std::abs(g) < std::abs(f))) break;  // round-off reached
    slope = (g - f) / (next - times);
    times = next;
    f = g;
  }
  return std::abs(f) <= 1e-9 * std::abs(start) || std::abs(f) < 1e-18 ? times : std::nan("");
}

}  // namespace

ShapeStepResult shift_outline(const body::ShapePtr& shape, base::Analysis analysis,
                              const std::vector<OutlineShift>& shifts, RelocationCache* cache) {
  ShapeStepResult result;
  const mesh::Mesh& mesh = shape->mesh;
  const Outline outline = outline_of(mesh);
  const Steps steps = steps_of(mesh, outline, shifts);
  Points P = mesh::control_points(steps.facets, mesh.X);
  const double times = balance(analysis, P, steps);
  if (!std::isfinite(times)) {
    result.failure = "no shift of the free outline restores the volume of the body";
    return result;
  }
  for (std::size_t j = 0; j < P.size(); ++j) P[j] += steps.by[j] + times * steps.free[j];
  auto next = std::make_shared<body::Shape>(*shape);
  next->mesh.X = mesh::middle_nodes(steps.facets, std::move(P));
  result.removed = strip_between(analysis, mesh.X, next->mesh.X, steps.facets);
  if (find_crossing(next->mesh)) {
    result.failure = "the shifted outline crosses itself";
    return result;
  }
  relocate(next->mesh, next->born, cache);
  result.min_quality = mesh::poorest_cell(next->mesh).scaled_jacobian;
  result.shape = std::move(next);
  return result;
}

}  // namespace reye::adapt
