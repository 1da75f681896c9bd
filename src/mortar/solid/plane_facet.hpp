#pragma once
#include "base/space.hpp"
#include "mortar/solid/clip.hpp"
#include "mortar/solid/facet_functions.hpp"

/// Facets seen along the normal of a plane.
namespace reye::mortar {

using base::Points3;
using base::Vec3;

/// A plane through `origin` with unit normal n = t1 x t2.
struct PlaneFrame {
  Vec3 origin, n, t1, t2;
};

/// The plane through the mean of a facet's corners along its mean normal int n dA / |int n dA|; t1 follows the first
/// edge, so that it turns with the facet. Throws base::MeshError where the facet has no area.
PlaneFrame plane_of(const mesh::Facet& facet, const Points3& x);

/// A part of a facet for clipping: a convex polygon of the plane, and an affine guess of the place on the facet,
/// xi = xi0 + B (y - y0). On affine facets it is exact, else on a quad4 the tangent at its middle, on tri6 that of one
/// of four straight triangles between corners and middles of edges.
struct PlanePiece {
  ConvexPolygon outline;
  Vec2 lo, hi;  ///< box round the outline
  Vec2 xi0, y0;
  Eigen::Matrix2d B;
  bool follow = false;  ///< the guess is mended by Newton's method on the facet's own shape functions
};

/// A facet in a plane's coordinates y, with heights above it.
struct PlaneFacet {
  mesh::FacetKind kind = mesh::FacetKind::tri3;
  int count = 0;
  std::array<Vec2, mesh::most_facet_nodes> y;
  FacetValues height{};
  bool affine = true;  ///< seen in the plane, places on the facet are linear in y: tri3, parallelograms, straight tri6
  double skew = 0.0;   ///< of a quad4: |c_4| / min(|c_1|, |c_2|) of its map; zero for parallelograms
  double size = 0.0;   ///< the longer side of the box round its points [mm]
  FacetPolynomial<Vec2> map;  ///< y of places on the facet
  std::array<PlanePiece, 4> pieces;
  int piece_count = 0;
};

/// Projects a facet. Parts that look against the normal (with `facing` = -1: along it) are left out. A quad4 that is
/// not convex in the plane is split for clipping into two triangles.
void project_facet(const PlaneFrame& frame, const mesh::Facet& facet, const Points3& x, int facing, PlaneFacet& seen);

/// A place on a facet and its shape functions there.
struct FacetPlace {
  Vec2 xi;
  FacetValues N;
};

/// The place of a piece that is seen at y: the inverse of y = sum N_j(xi) y_j. Where Newton's method finds none (a
/// facet that bends away from view) the place on the straight piece stands for it.
FacetPlace place_at(const PlaneFacet& seen, const PlanePiece& piece, const Vec2& y);

/// The height above the plane at y, for the search: on the straight piece.
double height_at(const PlaneFacet& seen, const PlanePiece& piece, const Vec2& y);

}  // namespace reye::mortar
