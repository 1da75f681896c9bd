#include "mortar/solid/plane_facet.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mortar/solid/facet_geometry.hpp"

namespace reye::mortar {

namespace {

using mesh::Facet;
using mesh::FacetKind;

constexpr int newton_steps = 12;

/// Points that differ by less than this part of a facet's size from where an affine map has them are taken as there.
constexpr double bent = 1e-14;

void box_in(PlanePiece& piece) {
  piece.lo = piece.hi = piece.outline.corners[0];
  for (int i = 1; i < piece.outline.count; ++i) {
    piece.lo = piece.lo.cwiseMin(piece.outline.corners[i]);
    piece.hi = piece.hi.cwiseMax(piece.outline.corners[i]);
  }
}

/// Reverses a polygon that runs clockwise.
void turn_round(ConvexPolygon& polygon) {
  for (int i = 0, j = polygon.count - 1; i < j; ++i, --j) std::swap(polygon.corners[i], polygon.corners[j]);
}

/// Adds a straight triangle between three places of the facet, unless it looks the wrong way or has no area.
void add_triangle(PlaneFacet& seen, const std::array<Vec2, 3>& y, const std::array<Vec2, 3>& xi, int facing,
                  bool follow) {
  Eigen::Matrix2d edges, reference;
  edges << y[1] - y[0], y[2] - y[0];
  reference << xi[1] - xi[0], xi[2] - xi[0];
  const double twice = edges.determinant();
  if (twice * facing <= 1e-14 * seen.size * seen.size) return;
  auto& piece = seen.pieces[seen.piece_count++];
  piece.outline.count = 3;
  for (std::size_t i = 0; i < 3; ++i) piece.outline.corners[i] = y[i];
  if (facing < 0) turn_round(piece.outline);
  piece.xi0 = xi[0];
  piece.y0 = y[0];
  piece.B = reference * edges.inverse();
  piece.follow = follow;
  box_in(piece);
}

void add_triangle(PlaneFacet& seen, int a, int b, int c, int facing) {
  const auto at = [&](int j) { return reference_place(seen.kind, j); };
  add_triangle(seen, {seen.y[a], seen.y[b], seen.y[c]}, {at(a), at(b), at(c)}, facing, false);
}

/// Whether a projected quad4 is convex, with corners that differ from straight ones and each other.
bool convex(const PlaneFacet& seen, int facing) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 here = seen.y[(i + 1) % 4] - seen.y[i], next = seen.y[(i + 2) % 4] - seen.y[(i + 1) % 4];
    if (base::cross(here, next) * facing <= 1e-6 * here.norm() * next.norm()) return false;
  }
  return true;
}

void add_quadrangle(PlaneFacet& seen, int facing) {
  auto& piece = seen.pieces[seen.piece_count++];
  const auto& y = seen.y;
  piece.outline.count = 4;
  for (std::size_t i = 0; i < 4; ++i) piece.outline.corners[i] = y[i];
  if (facing < 0) turn_round(piece.outline);
  const auto& c = seen.map.c;
  Eigen::Matrix2d tangents;
  tangents << c[1], c[2];
  piece.xi0.setZero();
  piece.y0 = c[0];
  piece.B = tangents.inverse();
  seen.affine = c[4].norm() <= bent * seen.size;
  seen.skew = c[4].norm() / std::min(c[1].norm(), c[2].norm());
  piece.follow = !seen.affine;
  box_in(piece);
}

/// Four straight triangles between the corners and the middles of the curved edges.
void add_curved(PlaneFacet& seen, int facing) {
  std::array<Vec2, 6> y = seen.y, xi;
  for (std::size_t e = 0; e < 3; ++e) y[3 + e] = 0.5 * y[3 + e] + 0.25 * (y[e] + y[(e + 1) % 3]);
  for (int j = 0; j < 6; ++j) xi[j] = reference_place(seen.kind, j);
  for (std::size_t e = 0; e < 3; ++e)
    seen.affine = seen.affine && (seen.y[3 + e] - 0.5 * (y[e] + y[(e + 1) % 3])).norm() <= bent * seen.size;
  constexpr std::array<std::array<int, 3>, 4> parts{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
  for (const auto& [a, b, c] : parts)
    add_triangle(seen, {y[a], y[b], y[c]}, {xi[a], xi[b], xi[c]}, facing, !seen.affine);
}

/// The place seen at y, from a guess; the guess where Newton's method finds none. After a step of 1e-8 the rest is of
/// round-off's size.
Vec2 followed(const PlaneFacet& seen, const Vec2& guess, const Vec2& y) {
  Vec2 xi = guess;
  for (int i = 0; i < newton_steps; ++i) {
    const Vec2 r = seen.map.dr(xi), s = seen.map.ds(xi), miss = y - seen.map.at(xi);
    const Vec2 step = Vec2(base::cross(miss, s), base::cross(r, miss)) / base::cross(r, s);
    xi += step;
    if (!(step.squaredNorm() > 1e-16)) return (xi - guess).squaredNorm() <= 1.0 ? xi : guess;
  }
  return guess;
}

}  // namespace

PlaneFrame plane_of(const Facet& facet, const Points3& x) {
  PlaneFrame frame;
  frame.n = unit_normal(facet, x);
  frame.origin.setZero();
  const int corners = mesh::facet_corners(facet.kind);
  for (int j = 0; j < corners; ++j) frame.origin += x[facet.nodes[j]] / corners;
  Vec3 along = x[facet.nodes[1]] - x[facet.nodes[0]];
  along -= along.dot(frame.n) * frame.n;
  frame.t1 = along.squaredNorm() > 0.0 ? Vec3(along.normalized()) : Vec3(frame.n.unitOrthogonal());
  frame.t2 = frame.n.cross(frame.t1);
  return frame;
}

void project_facet(const PlaneFrame& frame, const Facet& facet, const Points3& x, int facing, PlaneFacet& seen) {
  seen.kind = facet.kind;
  seen.count = facet.count();
  seen.piece_count = 0;
  for (int j = 0; j < seen.count; ++j) {
    const Vec3 from = x[facet.nodes[j]] - frame.origin;
    seen.y[j] = {from.dot(frame.t1), from.dot(frame.t2)};
    seen.height[j] = from.dot(frame.n);
  }
  Vec2 lo = seen.y[0], hi = seen.y[0];
  for (int j = 1; j < seen.count; ++j) {
    lo = lo.cwiseMin(seen.y[j]);
    hi = hi.cwiseMax(seen.y[j]);
  }
  seen.size = (hi - lo).maxCoeff();
  seen.map = facet_polynomial<Vec2>(seen.kind, [&](int j) -> const Vec2& { return seen.y[j]; });
  seen.affine = true;
  seen.skew = 0.0;
  if (seen.kind == FacetKind::tri3) return add_triangle(seen, 0, 1, 2, facing);
  if (seen.kind == FacetKind::tri6) return add_curved(seen, facing);
  if (convex(seen, facing)) return add_quadrangle(seen, facing);
  seen.affine = false;
  seen.skew = 1.0;
  add_triangle(seen, 0, 1, 2, facing);
  add_triangle(seen, 0, 2, 3, facing);
}

FacetPlace place_at(const PlaneFacet& seen, const PlanePiece& piece, const Vec2& y) {
  const Vec2 guess = piece.xi0 + piece.B * (y - piece.y0);
  if (!piece.follow) return {guess, skin_functions(seen.kind, guess)};
  const Vec2 xi = followed(seen, guess, y);
  return {xi, skin_functions(seen.kind, xi)};
}

double height_at(const PlaneFacet& seen, const PlanePiece& piece, const Vec2& y) {
  const auto N = skin_functions(seen.kind, piece.xi0 + piece.B * (y - piece.y0));
  double height = 0.0;
  for (int j = 0; j < seen.count; ++j) height += N[j] * seen.height[j];
  return height;
}

}  // namespace reye::mortar
