#include "adapt/shape/outline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace reye::adapt {

namespace {

/// Which of a node's two outline facets belong to a boundary.
struct Sides {
  bool before = false, after = false;
};

std::map<int, Sides> sides_of(const mesh::Boundary& boundary) {
  std::map<int, Sides> sides;
  for (const auto& chain : boundary)
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      sides[chain[k]].after = true;
      sides[chain[k + 1]].before = true;
    }
  return sides;
}

void add_loss(WornNode& node, const Sides& sides, double volume) {
  if (sides.before && sides.after)
    node.both += volume;
  else if (sides.before)
    node.before += volume;
  else
    node.after += volume;
}

Vec2 unit(const Vec2& v) { return v / v.norm(); }

/// Offset by W[0] from the facet with normal n[0] and by W[1] from that with n[1].
Vec2 corner_step(const std::array<Vec2, 2>& n, const std::array<double, 2>& W) {
  const double det = base::cross(n[0], n[1]);
  return -1.0 / det * Vec2{W[0] * n[1].y() - W[1] * n[0].y(), W[1] * n[0].x() - W[0] * n[1].x()};
}

double ratio(double volume, double length) { return volume > 0.0 ? volume / length : 0.0; }

/// The share of the end `node` of a facet in its length.
double share(Analysis analysis, const Points& P, const LineFacet& facet, int node) {
  const int other = facet[0] == node ? facet[1] : facet[0];
  return mesh::nodal_shares(mesh::kind_of(facet), {P[node], P[other], P[std::max(facet[2], 0)]}, analysis)[0];
}

}  // namespace

Outline outline_of(const mesh::Mesh& mesh) {
  Outline outline{std::vector<int>(mesh.X.size(), -1), std::vector<int>(mesh.X.size(), -1),
                  std::vector<char>(mesh.X.size(), 0)};
  const bool quadratic = mesh::order(mesh.kind) == 2;
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      outline.after[loop[k]] = loop[k + 1];
      outline.before[loop[k + 1]] = loop[k];
      outline.middle[loop[k]] = quadratic && k % 2 == 1;
    }
  return outline;
}

std::vector<WornNode> worn_nodes(const mesh::Mesh& mesh, const std::vector<WornBoundary>& worn) {
  std::map<int, WornNode> losses;
  for (const auto& [name, removed] : worn) {
    const auto& boundary = mesh.boundaries.at(name);
    const auto nodes = mesh::nodes_of(boundary);
    const auto sides = sides_of(boundary);
    assert(nodes.size() == removed.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (removed[k] != 0.0) add_loss(losses[nodes[k]], sides.at(nodes[k]), removed[k]);
  }
  std::vector<WornNode> result;
  result.reserve(losses.size());
  for (auto& [node, loss] : losses) {
    loss.node = node;
    result.push_back(loss);
  }
  return result;
}

std::vector<LineFacet> touched_facets(const Outline& outline, const std::vector<WornNode>& nodes) {
  std::set<int> starts;
  for (const auto& worn : nodes) {
    if (!outline.middle[worn.node]) starts.insert(worn.node);
    starts.insert(outline.middle[worn.node] ? outline.before[worn.node] : outline.facet_before(worn.node)[0]);
  }
  std::vector<LineFacet> facets;
  for (int a : starts) facets.push_back(outline.facet_after(a));
  return facets;
}

Vec2 nodal_step(Analysis analysis, const Points& P, const Outline& outline, const WornNode& worn) {
  const Vec2 &x = P[worn.node], &p = P[outline.before[worn.node]], &q = P[outline.after[worn.node]];
  const std::array<Vec2, 2> t{unit(x - p), unit(q - x)};
  const std::array<Vec2, 2> n{base::right_of(t[0]), base::right_of(t[1])};
  const std::array<double, 2> A{share(analysis, P, outline.facet_before(worn.node), worn.node),
                                share(analysis, P, outline.facet_after(worn.node), worn.node)};
  if (std::abs(std::atan2(base::cross(t[0], t[1]), t[0].dot(t[1]))) > mesh::smooth_angle) {
    const double W = ratio(worn.both, A[0] + A[1]);
    return corner_step(n, {W + ratio(worn.before, A[0]), W + ratio(worn.after, A[1])});
  }
  const bool first = worn.before + worn.both > 0.0, second = worn.after + worn.both > 0.0;
  const Vec2 N = unit(first && second ? Vec2(n[0] + n[1]) : first ? n[0] : n[1]);
  // volume per unit of advance along N; both facets move with the node, also the one that was not worn
  const double rate = A[0] * n[0].dot(N) + A[1] * n[1].dot(N);
  return -worn.total() / rate * N;
}

Vec2 control_step(Analysis analysis, const std::array<Vec2, 3>& facet, const std::array<Vec2, 2>& ends, double volume) {
  const auto& [a, b, c] = facet;
  const Vec2 t = unit(b - a), n = base::right_of(t);
  const std::array<Vec2, 2> end_normal{base::right_of(unit(c - a)), base::right_of(unit(b - c))};
  const double W = ratio(volume, mesh::nodal_shares(mesh::LineKind::line3, facet, analysis)[2]);
  return (-W + 0.5 * ends[0].dot(end_normal[0] - n) + 0.5 * ends[1].dot(end_normal[1] - n)) * n +
         0.5 * t.dot(ends[0] + ends[1]) * t;
}

}  // namespace reye::adapt
