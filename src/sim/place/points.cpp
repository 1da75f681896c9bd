#include "sim/place/points.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "fem/places.hpp"
#include "mesh/place.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

/// The longest edge at a node, of its cells or, without cells, of the outline.
double size_at(const mesh::Mesh& mesh, int node) {
  double size = 0.0;
  const auto look = [&](int a, int b) {
    if (a == node || b == node) size = std::max(size, (mesh.X[a] - mesh.X[b]).norm());
  };
  const int n = mesh::corners(mesh.kind);
  for (const auto& cell : mesh.cells)
    for (int k = 0; k < n; ++k) look(cell[k], cell[(k + 1) % n]);
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 1; k < loop.size(); ++k) look(loop[k - 1], loop[k]);
  return size;
}

/// A point of the scene on a body.
struct Point {
  std::string kind, name;  ///< "load", "weight"
  std::string key;         ///< of its place
  int body = 0;
  Vec2 at{0.0, 0.0};
};

/// The points of loads and supports.
std::vector<Point> acting_points(const Problem& problem) {
  std::vector<Point> points;
  for (std::size_t s = 0; s < problem.support_body.size(); ++s)
    if (const auto& support = problem.scene.supports[s]; support.point_mm && problem.support_body[s] >= 0)
      points.push_back({"support", support.name, "support." + support.name + ".point_mm", problem.support_body[s],
                        *support.point_mm});
  for (int b = 0; b < problem.body_count(); ++b)
    for (const auto& load : problem.inputs[b].point_loads)
      points.push_back({"load", load.name, "load." + load.name + ".point_mm", b, load.point_mm});
  return points;
}

std::vector<Point> probed_points(const Problem& problem) {
  std::vector<Point> points;
  for (const auto& probe : problem.scene.output.probes)
    for (int b = 0; b < problem.body_count(); ++b)
      if (problem.inputs[b].name == probe.body)
        points.push_back({"probe", probe.name, "output.probes." + probe.name + ".at_mm", b, probe.at_mm});
  return points;
}

}  // namespace

std::vector<base::Issue> points_outside(const Problem& problem) {
  constexpr double tolerance =
      0.25;  // of an element: as near, points count as those of the outline that they are drawn to
  std::vector<base::Issue> issues;
  auto points = acting_points(problem);
  for (auto& probe : probed_points(problem)) points.push_back(std::move(probe));
  for (const auto& point : points) {
    const auto place = mesh::place_of(problem.shapes[point.body]->mesh, point.at);
    if (place.inside || place.distance <= tolerance * place.facet) continue;
    issues.push_back(
        {point.key, base::formatted("[%.6g, %.6g]", point.at.x(), point.at.y()),
         base::formatted(
             "lies outside of body %s, whose nearest place is (%.6g, %.6g), %.4g mm away; put the point on the body",
             problem.inputs[point.body].name.c_str(), place.nearest.x() + 0.0, place.nearest.y() + 0.0,
             place.distance)});
  }
  return issues;
}

void warn_of_points(Problem& problem) {
  for (const auto& point : acting_points(problem)) {
    const mesh::Mesh& mesh = problem.shapes[point.body]->mesh;
    const int node = fem::nearest_node(mesh, point.at);
    const double away = (mesh.X[node] - point.at).norm(), size = size_at(mesh, node);
    if (away <= 0.5 * size) continue;
    warn(
        problem.warnings,
        {"point", point.kind + " " + point.name,
         base::formatted(
             "Its point (%.6g, %.6g) mm is no node of the mesh of body %s: it acts on the nearest one, %.3g mm away at "
             "(%.6g, %.6g) mm. Make the mesh finer there, or give it a node at the point.",
             point.at.x(), point.at.y(), problem.inputs[point.body].name.c_str(), away, mesh.X[node].x(),
             mesh.X[node].y()),
         away / size});
  }
}

}  // namespace reye::sim
