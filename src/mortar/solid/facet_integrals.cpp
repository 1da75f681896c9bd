#include "mortar/solid/facet_integrals.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "base/errors.hpp"

namespace reye::mortar {

namespace {

using mesh::Facet;
using mesh::FacetKind;

/// Facets whose normals make a smaller angle than this cosine's against each other look away: they are not paired.
constexpr double least_facing = 0.2;

/// A quadrangle this far from a parallelogram is integrated to degree 8; a rule of degree 5 errs by 1e-6 there, and by
/// the square of it for less.
constexpr double distorted = 0.03;

/// Integrands are products psi N. On affine facets they are polynomials, of degree 2 on tri3, at most 4 else: exact. On
/// distorted quad4 they are irrational, on curved tri6 nearly of degree 4.
int degree_for(const PlaneFacet& a, const PlaneFacet& b) {
  if (std::max(a.skew, b.skew) > distorted) return 8;
  const auto curved = [](const PlaneFacet& facet) { return facet.kind == FacetKind::tri6 && !facet.affine; };
  if (curved(a) || curved(b)) return 6;
  return a.kind == FacetKind::tri3 && b.kind == FacetKind::tri3 ? 2 : 5;
}

/// Area of the facet, where areas are measured, per area of the plane at a place.
double stretch(const FacetMaps& maps, const Vec3& n, const Vec2& xi) {
  const Vec3 a = maps.x.dr(xi).cross(maps.x.ds(xi));
  const double seen = a.dot(n), whole = a.norm();
  if (!(seen > 0.05 * whole)) {
    const Vec3 at = maps.x.at(xi);
    throw base::MeshError("a facet of a contact folds over, at x = " + std::to_string(at.x()) +
                          ", y = " + std::to_string(at.y()) + ", z = " + std::to_string(at.z()) + " mm");
  }
  return maps.X.dr(xi).cross(maps.X.ds(xi)).norm() / seen;
}

/// Places the points of a polygon that a piece of each facet has in common, triangle by triangle about its first
/// corner.
void place_polygon(const Vec3& n, const PlanePiece& own, const PlanePiece& other, const ConvexPolygon& common,
                   SkinWorkspace& w) {
  const auto& y = common.corners;
  const auto rule = triangle_rule(degree_for(w.own, w.other));
  for (int i = 2; i < common.count; ++i) {
    const Vec2 along = y[i - 1] - y[0], across = y[i] - y[0];
    const double area = 0.5 * base::cross(along, across);
    if (area <= 0.0) continue;
    w.covered += area;
    for (const auto& [at, weight] : rule) {
      const Vec2 here = y[0] + at.x() * along + at.y() * across;
      auto& q = w.points.emplace_back();
      const auto place = place_at(w.own, own, here);
      q.xi = place.xi;
      q.N = place.N;
      q.Nm = place_at(w.other, other, here).N;
      q.weight = weight * area * stretch(w.maps, n, q.xi);
      q.pair = static_cast<int>(w.pairs.size());
    }
  }
}

bool boxes_meet(const PlanePiece& a, const PlanePiece& b) {
  return a.lo.x() < b.hi.x() && b.lo.x() < a.hi.x() && a.lo.y() < b.hi.y() && b.lo.y() < a.hi.y();
}

/// Clips all pieces of both facets; what is farther apart than the search distance at its middle is left out.
void clip_pair(double search_mm, const Vec3& n, SkinWorkspace& w) {
  const double tolerance = clip_tolerance * w.own.size;
  for (int i = 0; i < w.own.piece_count; ++i)
    for (int k = 0; k < w.other.piece_count; ++k) {
      const auto &own = w.own.pieces[i], &other = w.other.pieces[k];
      if (!boxes_meet(own, other)) continue;
      const auto common = overlap(own.outline, other.outline, tolerance);
      if (common.count == 0) continue;
      const Vec2 middle = polygon_middle(common);
      const double gap = height_at(w.other, other, middle) - height_at(w.own, own, middle);
      if (std::abs(gap) <= search_mm) place_polygon(n, own, other, common, w);
    }
}

/// Whether a primary facet may cover a part: it looks this way, and comes near in the plane.
bool may_cover(const SkinSides& sides, const PlaneFrame& frame, double radius, int other) {
  if (frame.n.dot(sides.primary_normals[other]) > -least_facing) return false;
  const Vec3 from = sides.primary_middles[other] - frame.origin;
  const double height = from.dot(frame.n), reach = radius + sides.primary_radii[other];
  return from.squaredNorm() - height * height <= reach * reach;
}

double radius_round(const PlaneFacet& seen) {
  double square = 0.0;
  for (int j = 0; j < seen.count; ++j) square = std::max(square, seen.y[j].squaredNorm());
  return std::sqrt(square);
}

/// The column of a primary point.
SkinColumn& column(SkinWorkspace& w, int primary) {
  int& place = w.column_of[primary];
  if (place < 0) {
    place = static_cast<int>(w.columns.size());
    w.columns.push_back({primary, {}, {}});
  }
  return w.columns[place];
}

/// int P_k N_l and int N_k N_l of a pair of facets, k of the secondary one, l of the primary one.
struct PairMoments {
  std::array<FacetValues, mesh::most_facet_nodes> P{}, N{};

  void add(const SkinPoint& q) {
    for (std::size_t k = 0; k < P.size(); ++k) {
      const double of_P = q.weight * q.P[k], of_N = q.weight * q.N[k];
      for (std::size_t l = 0; l < q.Nm.size(); ++l) {
        P[k][l] += of_P * q.Nm[l];
        N[k][l] += of_N * q.Nm[l];
      }
    }
  }
};

/// Adds what a pair of facets contributes to the columns of M and T.
void add_pair(const Multipliers& basis, const PairMoments& moments, const Facet& other, int count, SkinWorkspace& w) {
  for (int l = 0; l < other.count(); ++l) {
    auto& c = column(w, other.nodes[l]);
    for (int j = 0; j < count; ++j)
      for (int k = 0; k < count; ++k) {
        c.M[j] += basis.a[j][k] * moments.P[k][l];
        c.T[j] += basis.share[j][k] * moments.N[k][l];
      }
  }
}

/// D_jk = int psi_j N_k for points k that are cut; D_jj so that its row sum is that of M.
void close_rows(const FacetCut& cut, int count, SkinWorkspace& w) {
  for (int j = 0; j < count; ++j) {
    double sum = 0.0;
    for (const auto& c : w.columns) sum += c.M[j];
    for (int k = 0; k < count; ++k)
      if (cut[k]) sum -= w.D[j][k];
    if (!cut[j]) w.D[j][j] = sum;
  }
}

}  // namespace

bool place_points(const SkinSides& sides, int facet, std::span<const int> opposite, SkinWorkspace& w) {
  w.points.clear();
  w.pairs.clear();
  w.plane_area = w.covered = 0.0;
  const Facet& own = sides.secondary.facets[facet];
  const auto frame = plane_of(own, sides.secondary.x);
  project_facet(frame, own, sides.secondary.x, 1, w.own);
  const auto polynomial = [&](const Points3& x) {
    return facet_polynomial<Vec3>(own.kind, [&](int j) -> const Vec3& { return x[own.nodes[j]]; });
  };
  w.maps = {polynomial(sides.secondary.x), polynomial(sides.secondary.measured())};
  for (int i = 0; i < w.own.piece_count; ++i) w.plane_area += polygon_area(w.own.pieces[i].outline);
  const double radius = radius_round(w.own);
  for (int other : opposite) {
    if (!may_cover(sides, frame, radius, other)) continue;
    project_facet(frame, sides.primary.facets[other], sides.primary.x, -1, w.other);
    const std::size_t before = w.points.size();
    clip_pair(sides.search_mm, frame.n, w);
    if (w.points.size() > before) w.pairs.push_back(other);
  }
  return w.covered >= least_covered * w.plane_area && !w.points.empty();
}

FacetValues covered_areas(const SkinWorkspace& w) {
  FacetValues areas{};
  for (const auto& q : w.points)
    for (int j = 0; j < w.own.count; ++j) areas[j] += q.weight * q.N[j];
  return areas;
}

void integrate_points(const SkinSides& sides, const FacetCut& cut, SkinWorkspace& w) {
  const int count = w.own.count;
  orthonormalise(w.own.kind, w.points);
  const auto basis = multipliers(w.own.kind, cut, w.points);
  for (const auto& c : w.columns) w.column_of[c.primary] = -1;
  w.columns.clear();
  w.column_of.resize(sides.primary.x.size(), -1);
  w.D = {};
  for (std::size_t begin = 0; begin < w.points.size();) {
    const int pair = w.points[begin].pair;
    const Facet& other = sides.primary.facets[w.pairs[pair]];
    PairMoments own;
    std::size_t end = begin;
    for (; end < w.points.size() && w.points[end].pair == pair; ++end) own.add(w.points[end]);
    add_pair(basis, own, other, count, w);
    begin = end;
  }
  for (const auto& q : w.points)
    for (int k = 0; k < count; ++k) {
      if (!cut[k]) continue;
      for (int j = 0; j < count; ++j)
        for (int l = 0; l < count; ++l) w.D[j][k] += q.weight * basis.a[j][l] * q.P[l] * q.N[k];
    }
  close_rows(cut, count, w);
}

}  // namespace reye::mortar
