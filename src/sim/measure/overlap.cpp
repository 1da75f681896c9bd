#include "sim/measure/overlap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include "base/formatted.hpp"
#include "mesh/measure.hpp"

namespace reye::sim {

namespace {

constexpr double least = 0.05;  ///< of the facet that a node lies behind

/// The outline of a body where it is, and per node the sides of contacts it is on: 2 * contact + (0 secondary, 1
/// primary).
struct Outline {
  base::Points x;
  std::vector<std::array<int, 2>> pieces;
  std::vector<int> nodes;
  std::vector<std::vector<int>> sides;
  Eigen::AlignedBox2d box;
};

/// Notes at the nodes of a body the sides on which they lie: of each contact and bond the secondary and the primary.
void mark_sides(const Problem& problem, const mesh::Mesh& mesh, int body, Outline& o) {
  o.sides.resize(o.x.size());
  const auto mark = [&](const contact::BoundaryRef& ref, int side) {
    if (ref.body != body) return;
    for (int node : mesh::nodes_of(mesh.boundaries.at(ref.boundary))) o.sides[node].push_back(side);
  };
  int side = 0;
  for (const auto* joints : {&problem.contacts, &problem.bonds})
    for (const auto& joint : *joints) {
      mark(joint.secondary, side++);
      for (const auto& ref : joint.primary) mark(ref, side);
      ++side;
    }
}

Outline outline_of(const Problem& problem, const body::ShapePtr& shape, const std::vector<Vec2>& u, int body) {
  const auto& mesh = shape->mesh;
  Outline o;
  o.x = mesh.X;
  for (std::size_t k = 0; k < u.size(); ++k) o.x[k] += u[k];
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      o.pieces.push_back({loop[k], loop[k + 1]});
      o.nodes.push_back(loop[k]);
      o.box.extend(o.x[loop[k]]);
    }
  mark_sides(problem, mesh, body, o);
  return o;
}

/// Whether a contact exists between a node of one body and a piece of the other.
bool in_contact(const std::vector<int>& sides, const Outline& other, const std::array<int, 2>& piece) {
  const auto on = [&](int node, int side) {
    return std::find(other.sides[node].begin(), other.sides[node].end(), side) != other.sides[node].end();
  };
  return std::any_of(sides.begin(), sides.end(),
                     [&](int side) { return on(piece[0], side ^ 1) && on(piece[1], side ^ 1); });
}

/// Depth of a node inside the other body where no contact exists between them; 0 outside.
double depth_of(const Outline& own, int node, const Outline& other) {
  const Vec2& x = own.x[node];
  bool inside = false;
  double depth = std::numeric_limits<double>::infinity();
  const std::array<int, 2>* behind = nullptr;
  for (const auto& piece : other.pieces) {
    const Vec2 &a = other.x[piece[0]], &b = other.x[piece[1]], e = b - a;
    if ((a.y() > x.y()) != (b.y() > x.y()) && x.x() < a.x() + e.x() * (x.y() - a.y()) / e.y()) inside = !inside;
    const double distance = mesh::distance_to_edge(a, b, x);
    if (distance >= depth) continue;
    depth = distance;
    behind = &piece;
  }
  if (!inside || in_contact(own.sides[node], other, *behind)) return 0.0;
  return depth > least * (other.x[(*behind)[1]] - other.x[(*behind)[0]]).norm() ? depth : 0.0;
}

void look_inside(const std::vector<Outline>& outlines, int body, int other, Overlap& deepest) {
  for (int node : outlines[body].nodes) {
    if (!outlines[other].box.contains(outlines[body].x[node])) continue;
    if (const double depth = depth_of(outlines[body], node, outlines[other]); depth > deepest.depth_mm)
      deepest = {body, other, outlines[body].x[node], depth};
  }
}

}  // namespace

std::vector<Overlap> overlaps(const Problem& problem, const std::vector<body::ShapePtr>& shapes,
                              const std::vector<std::vector<Vec2>>& u) {
  std::vector<Outline> outlines;
  for (int b = 0; b < problem.body_count(); ++b)
    outlines.push_back(outline_of(problem, shapes[b], u.empty() ? std::vector<Vec2>() : u[b], b));
  std::vector<Overlap> found;
  for (int a = 0; a < problem.body_count(); ++a)
    for (int b = a + 1; b < problem.body_count(); ++b) {
      if (!outlines[a].box.intersects(outlines[b].box)) continue;
      Overlap deepest;
      look_inside(outlines, a, b, deepest);
      look_inside(outlines, b, a, deepest);
      if (deepest.depth_mm > 0.0) found.push_back(deepest);
    }
  return found;
}

std::vector<Warning> overlap_warnings(const Problem& problem, const std::vector<body::ShapePtr>& shapes,
                                      const std::vector<std::vector<Vec2>>& u) {
  std::vector<Warning> warnings;
  for (const auto& o : overlaps(problem, shapes, u)) {
    const auto &name = problem.inputs[o.body].name, &other = problem.inputs[o.other].name;
    const std::string text = base::formatted(
        "body %s lies up to %.3g mm inside body %s, at (%.4g, %.4g) mm, where no contact keeps them apart; "
        "define one there, or name all of the boundaries that can touch",
        name.c_str(), o.depth_mm, other.c_str(), o.at.x(), o.at.y());
    warnings.push_back(
        {"overlap", "bodies " + std::min(name, other) + " and " + std::max(name, other), text, o.depth_mm});
  }
  return warnings;
}

}  // namespace reye::sim
