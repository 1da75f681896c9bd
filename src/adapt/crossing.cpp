#include "adapt/crossing.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "adapt/strip.hpp"

namespace reye::adapt {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;

Point point(const base::Vec2& x) { return {x.x(), x.y()}; }

std::vector<Facet> facets_of(const mesh::Mesh& mesh) {
  std::vector<Facet> facets;
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) facets.push_back({loop[k], loop[k + 1]});
  return facets;
}

/// Neighbours p -> q -> r share q; they clash only when r lies back on the line of p -> q.
bool folded(const Point& p, const Point& q, const Point& r) {
  return CGAL::orientation(p, q, r) == CGAL::COLLINEAR && CGAL::angle(p, q, r) == CGAL::ACUTE;
}

bool clash(const mesh::Mesh& mesh, const Facet& f, const Facet& g) {
  const auto at = [&](int node) { return point(mesh.X[node]); };
  if (f.b == g.a) return folded(at(f.a), at(f.b), at(g.b));
  if (g.b == f.a) return folded(at(g.a), at(g.b), at(f.b));
  return CGAL::do_intersect(Kernel::Segment_2(at(f.a), at(f.b)), Kernel::Segment_2(at(g.a), at(g.b)));
}

}  // namespace

std::optional<Crossing> find_crossing(const mesh::Mesh& mesh) {
  const auto facets = facets_of(mesh);
  std::vector<Box> boxes;
  for (int i = 0; i < static_cast<int>(facets.size()); ++i)
    boxes.emplace_back(point(mesh.X[facets[i].a]).bbox() + point(mesh.X[facets[i].b]).bbox(), i);
  std::optional<std::pair<int, int>> first;  // the smallest pair, so that the answer does not hang on box order
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& x, const Box& y) {
    const std::pair pair{std::min(x.info(), y.info()), std::max(x.info(), y.info())};
    if (!clash(mesh, facets[pair.first], facets[pair.second])) return;
    if (!first || pair < *first) first = pair;
  });
  if (!first) return std::nullopt;
  const auto &f = facets[first->first], &g = facets[first->second];
  return Crossing{{f.a, f.b}, {g.a, g.b}, 0.5 * (mesh.X[f.a] + mesh.X[f.b])};
}

}  // namespace reye::adapt
