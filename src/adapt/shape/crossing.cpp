#include "adapt/shape/crossing.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "adapt/shape/strip.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::adapt {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;

Point point(const base::Vec2& x) { return {x.x(), x.y()}; }

/// The outline as straight pieces: its points, the pieces, and the outline nodes each lies between.
struct Pieces {
  base::Points X;
  std::vector<LineFacet> facets, between;
};

/// Points on half a quadratic edge, from outline place k to the next one, both included.
std::vector<int> points_along(const mesh::Mesh& mesh, const mesh::Chain& loop, std::size_t k, base::Points& X) {
  constexpr int pieces = 4;
  const std::size_t first = k - k % 2;
  const mesh::QuadraticEdge edge{mesh.X[loop[first]], mesh.X[loop[first + 1]], mesh.X[loop[first + 2]]};
  std::vector<int> points{loop[k]};
  for (int i = 1; i < pieces; ++i) {
    points.push_back(static_cast<int>(X.size()));
    X.push_back(edge.at((k == first ? -1.0 : 0.0) + static_cast<double>(i) / pieces));
  }
  points.push_back(loop[k + 1]);
  return points;
}

Pieces pieces_of(const mesh::Mesh& mesh) {
  Pieces p{mesh.X, {}, {}};
  const bool straight = mesh::order(mesh.kind) == 1;
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const auto points = straight ? std::vector<int>{loop[k], loop[k + 1]} : points_along(mesh, loop, k, p.X);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        p.facets.push_back({points[i], points[i + 1]});
        p.between.push_back({loop[k], loop[k + 1]});
      }
    }
  return p;
}

/// Neighbours p -> q -> r share q; they clash only when r lies back on the line of p -> q.
bool folded(const Point& p, const Point& q, const Point& r) {
  return CGAL::orientation(p, q, r) == CGAL::COLLINEAR && CGAL::angle(p, q, r) == CGAL::ACUTE;
}

bool clash(const base::Points& X, const LineFacet& f, const LineFacet& g) {
  const auto at = [&](int node) { return point(X[node]); };
  if (f[1] == g[0]) return folded(at(f[0]), at(f[1]), at(g[1]));
  if (g[1] == f[0]) return folded(at(g[0]), at(g[1]), at(f[1]));
  return CGAL::do_intersect(Kernel::Segment_2(at(f[0]), at(f[1])), Kernel::Segment_2(at(g[0]), at(g[1])));
}

using SegmentNodes = std::array<int, 2>;

bool on(const mesh::Boundary& boundary, const SegmentNodes& facet) {
  for (const auto& chain : boundary)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      if (chain[i] == facet[0] && chain[i + 1] == facet[1]) return true;
  return false;
}

std::set<std::string> names_of(const mesh::Mesh& mesh, const SegmentNodes& facet) {
  std::set<std::string> names;
  for (const auto& [name, boundary] : mesh.boundaries)
    if (on(boundary, facet)) names.insert(name);
  return names;
}

/// A boundary of the facet that the other one is not on; "" when it has none.
std::string own_name(const mesh::Mesh& mesh, const SegmentNodes& facet, const SegmentNodes& other) {
  const auto theirs = names_of(mesh, other);
  for (const auto& name : names_of(mesh, facet))
    if (!theirs.contains(name)) return "boundary '" + name + "'";
  return {};
}

struct Place {
  std::size_t loop = 0, facet = 0;
};

Place place_of(const mesh::Mesh& mesh, const SegmentNodes& facet) {
  for (std::size_t l = 0; l < mesh.outline.size(); ++l)
    for (std::size_t i = 0; i + 1 < mesh.outline[l].size(); ++i)
      if (mesh.outline[l][i] == facet[0] && mesh.outline[l][i + 1] == facet[1]) return {l, i};
  return {};
}

/// Facets of one side: with the same boundaries, or without any and within a few facets of each other.
bool same_side(const mesh::Mesh& mesh, const Crossing& c) {
  const Place f = place_of(mesh, c.first), g = place_of(mesh, c.second);
  if (f.loop != g.loop) return false;
  const std::size_t n = mesh.outline[f.loop].size() - 1,
                    way = f.facet > g.facet ? f.facet - g.facet : g.facet - f.facet;
  if (std::min(way, n - way) == 1) return true;
  const auto names = names_of(mesh, c.first);
  if (names != names_of(mesh, c.second)) return false;
  constexpr std::size_t few = 4;
  return !names.empty() || std::min(way, n - way) <= few;
}

}  // namespace

std::string meaning(const Crossing& c, const mesh::Mesh& now, const mesh::Mesh& born) {
  const auto worn = [&](const SegmentNodes& f) { return now.X[f[0]] != born.X[f[0]] || now.X[f[1]] != born.X[f[1]]; };
  if (same_side(now, c)) return "the worn outline crosses itself";
  const bool both = worn(c.first) && worn(c.second);
  if (both && place_of(now, c.first).loop == place_of(now, c.second).loop) return "the body is worn into two pieces";
  const auto& met = worn(c.first) ? c.second : c.first;
  const std::string name = own_name(now, met, worn(c.first) ? c.first : c.second);
  return "worn through to " + (!name.empty() ? name : both ? "another part of the outline" : "the unworn outline");
}

std::optional<Crossing> find_crossing(const mesh::Mesh& mesh) {
  const auto [X, facets, between] = pieces_of(mesh);
  std::vector<Box> boxes;
  for (int i = 0; i < static_cast<int>(facets.size()); ++i)
    boxes.emplace_back(point(X[facets[i][0]]).bbox() + point(X[facets[i][1]]).bbox(), i);
  std::optional<std::pair<int, int>> first;  // the smallest pair, so that the answer does not depend on box order
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& x, const Box& y) {
    const std::pair pair{std::min(x.info(), y.info()), std::max(x.info(), y.info())};
    if (!clash(X, facets[pair.first], facets[pair.second])) return;
    if (!first || pair < *first) first = pair;
  });
  if (!first) return std::nullopt;
  const auto &f = between[first->first], &g = between[first->second];
  return Crossing{{f[0], f[1]}, {g[0], g[1]}, 0.5 * (mesh.X[f[0]] + mesh.X[f[1]])};
}

}  // namespace reye::adapt
