#include "cad/part/own_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/measure.hpp"
#include "mesh/outline.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::cad {

namespace {

const std::set<std::string>& names_of(const RawMesh& mesh, int a, int b) {
  static const std::set<std::string> none;
  const auto found = mesh.names.find(std::minmax(a, b));
  return found == mesh.names.end() ? none : found->second;
}

/// Whether an edge of the outline ends at loop[i], a node of a closed loop. Its corner is that of the tangents, by
/// quadratics where mid nodes lie beside it.
bool ends_at(const RawMesh& raw, const Points& X, const mesh::Chain& loop, std::size_t i) {
  const std::size_t order = mesh::order(raw.kind);
  if (i % order != 0) return false;
  const std::size_t last = loop.size() - 1;
  const int before = loop[(i + last - order) % last], here = loop[i], after = loop[i + order];
  Vec2 in = X[here] - X[before], out = X[after] - X[here];
  if (order == 2) {
    in = mesh::QuadraticEdge{X[before], X[loop[(i + last - 1) % last]], X[here]}.tangent(1.0);
    out = mesh::QuadraticEdge{X[here], X[loop[i + 1]], X[after]}.tangent(-1.0);
  }
  return std::abs(std::atan2(base::cross(in, out), in.dot(out))) > mesh::corner_angle ||
         names_of(raw, before, here) != names_of(raw, here, after);
}

EdgeType type_of(const Points& knots) {
  const Vec2 chord = knots.back() - knots.front();
  const bool straight = knots.front() != knots.back() && std::all_of(knots.begin(), knots.end(), [&](const Vec2& p) {
                          return std::abs(base::cross(chord, p - knots.front())) <= 1e-9 * chord.squaredNorm();
                        });
  if (straight) return EdgeType::line;
  const Vec2 u = knots[knots.size() / 3] - knots[0], v = knots[2 * knots.size() / 3] - knots[0];
  const double twice = 2.0 * base::cross(u, v);
  const Vec2 centre =
      Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(), u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
      twice;
  const bool circular = knots.size() > 3 && std::all_of(knots.begin(), knots.end(), [&](const Vec2& p) {
                          return std::abs((p - knots[0] - centre).norm() - centre.norm()) <= 1e-6 * centre.norm();
                        });
  return circular ? EdgeType::circle : EdgeType::spline;
}

/// Edges of one loop, which is turned so that it starts where an edge does.
Loop edges_of(const RawMesh& raw, const Points& X, mesh::Chain& loop) {
  for (std::size_t i = 0; i + 1 < loop.size(); ++i)
    if (ends_at(raw, X, loop, i)) {
      loop.pop_back();
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i), loop.end());
      loop.push_back(loop.front());
      break;
    }
  Loop edges;
  Points knots{X[loop[0]]};
  for (std::size_t i = 1; i < loop.size(); ++i) {
    knots.push_back(X[loop[i]]);
    if (i + 1 < loop.size() && !ends_at(raw, X, loop, i)) continue;
    const EdgeType type = type_of(knots);
    edges.push_back(make_polyline(type, std::move(knots)));
    edges.back().names = names_of(raw, loop[i - mesh::order(raw.kind)], loop[i]);
    knots = {X[loop[i]]};
  }
  return edges;
}

/// The corners in reverse, and the mid nodes so that each stays between its corners.
void turn_round(mesh::CellKind kind, mesh::Cell& cell) {
  const int n = mesh::corners(kind);
  std::reverse(cell.begin(), cell.begin() + n);
  if (mesh::order(kind) == 2) std::reverse(cell.begin() + n, cell.begin() + 2 * n - 1);
}

}  // namespace

Part part_with_mesh(const RawPart& raw, const Plane& plane) {
  mesh::Mesh mesh;
  mesh.kind = raw.mesh.kind;
  mesh.cells = raw.mesh.cells;
  for (const Vec3& p : raw.mesh.nodes) mesh.X.push_back(plane.map(p));
  for (mesh::Cell& cell : mesh.cells)
    if (mesh::cell_area(mesh.X, mesh.kind, cell) < 0.0) turn_round(mesh.kind, cell);
  mesh.outline = mesh::outline_of(mesh.X, mesh.kind, mesh.cells);
  Part part{raw.label, {}, {}};
  for (mesh::Chain& loop : mesh.outline) part.loops.push_back(edges_of(raw.mesh, mesh.X, loop));
  part.mesh = std::move(mesh);
  return part;
}

}  // namespace reye::cad
