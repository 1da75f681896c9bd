#include "sim/points.hpp"

#include <algorithm>
#include <cstdio>

#include "fem/assemble_loads.hpp"
#include "sim/warnings.hpp"

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

void look_at(Problem& problem, const std::string& what, int body, const Vec2& point) {
  const mesh::Mesh& mesh = problem.shapes[body]->mesh;
  const int node = fem::nearest_node(mesh, point);
  const double away = (mesh.X[node] - point).norm(), size = size_at(mesh, node);
  if (away <= 0.5 * size) return;
  char text[240];
  std::snprintf(text, sizeof text,
                "Its point (%.6g, %.6g) mm is no place of body %s: it acts on the nearest node, %.3g mm away at (%.6g, %.6g) mm. "
                "Put the point on the body.",
                point.x(), point.y(), problem.inputs[body].name.c_str(), away, mesh.X[node].x(), mesh.X[node].y());
  warn(problem.warnings, {"point", what, text, away / size});
}

}  // namespace

void warn_of_points(Problem& problem) {
  for (const auto& placed : problem.supports)
    if (placed.support.point_mm && placed.body >= 0)
      look_at(problem, "support " + placed.support.name, placed.body, *placed.support.point_mm);
  for (int b = 0; b < problem.body_count(); ++b)
    for (const auto& load : problem.inputs[b].point_loads) look_at(problem, "load " + load.name, b, load.point_mm);
}

}  // namespace reye::sim
