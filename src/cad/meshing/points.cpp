#include "cad/meshing/points.hpp"

#include <algorithm>
#include <limits>

#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

constexpr double beside_outline = 0.25;  ///< elements
constexpr double same = 1e-9;            ///< mm, and of the coordinates

/// The place of the outline nearest to a point, and how far away it is.
struct Nearest {
  Mark mark;
  double distance = std::numeric_limits<double>::infinity();
};

Nearest nearest_place(const Part& part, const Vec2& p) {
  Nearest best;
  for (int loop = 0; loop < static_cast<int>(part.loops.size()); ++loop)
    for (int edge = 0; edge < static_cast<int>(part.loops[loop].size()); ++edge)
      if (const Foot foot = foot_on(part.loops[loop][edge], p); foot.distance < best.distance)
        best = {{loop, edge, foot.s}, foot.distance};
  return best;
}

bool on_outline(const Nearest& place, const Vec2& p, const SizeField& size) {
  return place.distance <= beside_outline * size(p);
}

/// Nodes that may not be moved: those of the outline, and the vertices of points placed before.
std::vector<char> fixed_nodes(const mesh::Mesh& mesh) {
  std::vector<char> fixed(mesh.X.size(), 0);
  for (const auto& loop : mesh.outline)
    for (int node : loop) fixed[node] = 1;
  return fixed;
}

int nearest_free(const mesh::Mesh& mesh, const std::vector<char>& fixed, const Vec2& p) {
  int best = -1;
  for (int j = 0; j < mesh.node_count(); ++j)
    if (!fixed[j] && (best < 0 || (mesh.X[j] - p).squaredNorm() < (mesh.X[best] - p).squaredNorm())) best = j;
  return best;
}

/// The nodes after one of them has moved to p and the free ones within `reach` of it have followed.
Points drawn(const mesh::Mesh& mesh, const std::vector<char>& fixed, int node, const Vec2& p, double reach) {
  Points X = mesh.X;
  const Vec2 from = mesh.X[node], way = p - from;
  for (std::size_t j = 0; j < X.size(); ++j)
    if (!fixed[j]) X[j] += std::max(0.0, 1.0 - (X[j] - from).norm() / reach) * way;
  X[node] = p;
  return X;
}

}  // namespace

std::vector<Mark> marks_of(const Part& part, const std::vector<Vec2>& points, const SizeField& size) {
  std::vector<Mark> marks;
  for (const Vec2& p : points)
    if (const Nearest place = nearest_place(part, p); on_outline(place, p, size)) marks.push_back(place.mark);
  return marks;
}

void draw_to_points(mesh::Mesh& mesh, const Part& part, const std::vector<Vec2>& points, const SizeField& size) {
  constexpr double fair = 0.2;  // scaled Jacobian
  auto fixed = fixed_nodes(mesh);
  for (const Vec2& p : points) {
    if (mesh.cells.empty() || !contains(part, p) || on_outline(nearest_place(part, p), p, size)) continue;
    const int node = nearest_free(mesh, fixed, p);
    if (node < 0) return;
    const double least = std::min(fair, mesh::poorest_cell(mesh).scaled_jacobian);
    mesh::Mesh attempt = mesh;
    for (double reach : {3.0, 2.0, 1.2}) {
      attempt.X = drawn(mesh, fixed, node, p, reach * std::max(size(p), (p - mesh.X[node]).norm()));
      if (mesh::poorest_cell(attempt).scaled_jacobian < least) continue;
      fixed[node] = 1;
      mesh.X = attempt.X;
      break;
    }
  }
}

std::vector<int> vertices_at(const mesh::Mesh& mesh, const std::vector<Vec2>& points) {
  std::vector<int> vertices;
  for (const Vec2& p : points) {
    const auto nearer = [&](const Vec2& a, const Vec2& b) { return (a - p).squaredNorm() < (b - p).squaredNorm(); };
    const auto found = std::min_element(mesh.X.begin(), mesh.X.end(), nearer);
    if ((*found - p).norm() <= same * (1.0 + p.norm())) vertices.push_back(static_cast<int>(found - mesh.X.begin()));
  }
  return vertices;
}

}  // namespace reye::cad
