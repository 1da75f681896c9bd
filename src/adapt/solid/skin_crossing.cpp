#include "adapt/solid/skin_crossing.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>

#include "base/formatted.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::adapt {

namespace {

using SpaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SpacePoint = SpaceKernel::Point_3;
using SpaceBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

/// A flat piece of a facet between its nodes.
struct FlatPiece {
  std::array<int, 3> nodes;
  int facet;
};

SpacePoint point_of(const mesh::Vec3& x) { return {x.x(), x.y(), x.z()}; }

void add_pieces(const mesh::Facet& facet, int f, std::vector<FlatPiece>& pieces) {
  constexpr int triangle[1][3]{{0, 1, 2}}, square[2][3]{{0, 1, 2}, {0, 2, 3}},
      curved[4][3]{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  const auto add = [&](const int(&k)[3]) {
    pieces.push_back({{facet.nodes[k[0]], facet.nodes[k[1]], facet.nodes[k[2]]}, f});
  };
  if (facet.kind == mesh::FacetKind::tri3) std::for_each(std::begin(triangle), std::end(triangle), add);
  if (facet.kind == mesh::FacetKind::quad4) std::for_each(std::begin(square), std::end(square), add);
  if (facet.kind == mesh::FacetKind::tri6) std::for_each(std::begin(curved), std::end(curved), add);
}

std::vector<SpaceBox> boxes_round(const mesh::Points3& X, const std::vector<FlatPiece>& pieces) {
  std::vector<SpaceBox> boxes;
  for (int k = 0; k < static_cast<int>(pieces.size()); ++k) {
    const auto& [a, b, c] = pieces[k].nodes;
    boxes.emplace_back(point_of(X[a]).bbox() + point_of(X[b]).bbox() + point_of(X[c]).bbox(), k);
  }
  return boxes;
}

/// The nodes of a piece with those that another shares first; how many these are.
int shared_first(std::array<int, 3>& nodes, const std::array<int, 3>& other) {
  const auto is_shared = [&](int node) { return std::find(other.begin(), other.end(), node) != other.end(); };
  return static_cast<int>(std::stable_partition(nodes.begin(), nodes.end(), is_shared) - nodes.begin());
}

/// Whether two pieces have more in common than the nodes they share.
bool pieces_meet(const mesh::Points3& X, std::array<int, 3> f, std::array<int, 3> g) {
  const auto p = [&](int node) { return point_of(X[node]); };
  const int shared = shared_first(f, g);
  shared_first(g, f);
  const SpaceKernel::Triangle_3 F(p(f[0]), p(f[1]), p(f[2])), G(p(g[0]), p(g[1]), p(g[2]));
  if (shared == 3) return true;
  if (shared == 2)
    return CGAL::coplanar(p(f[0]), p(f[1]), p(f[2]), p(g[2])) &&
           CGAL::coplanar_orientation(p(f[0]), p(f[1]), p(f[2]), p(g[2])) == CGAL::POSITIVE;
  if (shared == 1)
    return CGAL::do_intersect(SpaceKernel::Segment_3(p(f[1]), p(f[2])), G) ||
           CGAL::do_intersect(SpaceKernel::Segment_3(p(g[1]), p(g[2])), F);
  return CGAL::do_intersect(F, G);
}

SkinCrossing crossing_at(const mesh::SolidMesh& mesh, int first, int second) {
  return {first, second, mesh::area_centroid(mesh.X, {mesh.skin[first]})};
}

bool has_moved(const mesh::Facet& facet, const mesh::SolidMesh& now, const mesh::SolidMesh& born) {
  return std::any_of(facet.nodes.begin(), facet.nodes.begin() + facet.count(),
                     [&](int node) { return now.X[node] != born.X[node]; });
}

/// A name of the one facet that the other does not have; empty when there is none.
std::string name_of_one(const mesh::SolidMesh& mesh, int facet, int other) {
  const auto holds = [](const std::vector<int>& facets, int f) {
    return std::find(facets.begin(), facets.end(), f) != facets.end();
  };
  for (const auto& [name, facets] : mesh.faces)
    if (holds(facets, facet) && !holds(facets, other)) return name;
  return {};
}

}  // namespace

std::optional<SkinCrossing> find_crossing(const mesh::SolidMesh& mesh, const std::vector<int>& moved) {
  std::vector<FlatPiece> all, some;
  for (int f = 0; f < static_cast<int>(mesh.skin.size()); ++f) add_pieces(mesh.skin[f], f, all);
  for (int f : moved) add_pieces(mesh.skin[f], f, some);
  auto all_boxes = boxes_round(mesh.X, all), some_boxes = boxes_round(mesh.X, some);
  std::optional<std::pair<int, int>> first;  // the smallest pair, so that the answer does not depend on box order
  CGAL::box_intersection_d(some_boxes.begin(), some_boxes.end(), all_boxes.begin(), all_boxes.end(),
                           [&](const SpaceBox& a, const SpaceBox& b) {
                             const FlatPiece &f = some[a.info()], &g = all[b.info()];
                             if (f.facet == g.facet || (first && *first <= std::pair{f.facet, g.facet})) return;
                             if (pieces_meet(mesh.X, f.nodes, g.nodes)) first = {f.facet, g.facet};
                           });
  if (!first) return std::nullopt;
  return crossing_at(mesh, first->first, first->second);
}

std::optional<SkinCrossing> find_fold(const mesh::Points3& before, const mesh::SolidMesh& mesh,
                                      const std::vector<int>& moved) {
  for (int f : moved)
    if (!(mesh::area_vector(before, mesh.skin[f]).dot(mesh::area_vector(mesh.X, mesh.skin[f])) > 0.0))
      return crossing_at(mesh, f, f);
  return std::nullopt;
}

std::string meaning(const SkinCrossing& crossing, const mesh::SolidMesh& now, const mesh::SolidMesh& born) {
  if (crossing.first == crossing.second) return "worn through: a facet of the surface is folded over";
  const bool first = has_moved(now.skin[crossing.first], now, born),
             second = has_moved(now.skin[crossing.second], now, born);
  const int met = first && !second ? crossing.second : crossing.first;
  const std::string name = name_of_one(now, met, met == crossing.first ? crossing.second : crossing.first);
  if (first && second) return "the worn surface crosses itself";
  return "worn through to " + (name.empty() ? "the unworn surface" : "face " + base::quoted(name));
}

}  // namespace reye::adapt
