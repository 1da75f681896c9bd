#pragma once
#include <array>
#include <set>
#include <string>
#include <vector>

#include "base/linalg.hpp"

namespace reye::cad {

using base::Points;
using base::Vec2;

enum class EdgeType { line, circle, spline };

std::string to_string(EdgeType type);

/// A CAD edge in the plane as a value: knots with unit tangents at known arc lengths, joined by cubic Hermite
/// pieces. A line has two knots; curves have about a thousand, which leaves 1e-11 of the radius on circles.
/// The outline of a mesh that came with its file is `straight`: its knots are the nodes, joined by straight lines.
struct Edge {
  EdgeType type = EdgeType::line;
  bool straight = false;
  Points knots;
  Points tangents;              ///< at the knots, in the direction of travel
  std::vector<double> arc;      ///< arc length at the knots, from zero [mm]
  std::set<std::string> names;  ///< physical curves it belongs to
  bool worn = false;            ///< drawn through the nodes of a worn outline, not by CAD

  double length() const { return arc.back(); }
  const Vec2& first() const { return knots.front(); }
  const Vec2& last() const { return knots.back(); }
};

/// Edge through knots with the directions of travel there (any length). Arc length of a piece: chord and the angle
/// between its end tangents, chord * (t/2) / sin(t/2), exact for circles.
Edge make_edge(EdgeType type, Points knots, Points directions);

/// Edge made of straight pieces.
Edge make_polyline(EdgeType type, Points knots);

/// Position at arc length s, clamped to the edge.
Vec2 at(const Edge& edge, double s);
/// Unit tangent at arc length s.
Vec2 tangent_at(const Edge& edge, double s);

Edge reversed(Edge edge);

/// The part of an edge between arc lengths 0 <= s0 < s1 <= length: the same curve, type and names. Knots within a tenth
/// of their piece of a cut are left out; the whole edge comes back unchanged.
Edge trimmed(const Edge& edge, double s0, double s1);

/// A closed edge that begins at arc length s.
Edge begun_at(const Edge& ring, double s);

/// The point of an edge nearest to p: arc length and distance.
struct Foot {
  double s = 0.0;
  double distance = 0.0;
};
Foot foot_on(const Edge& edge, const Vec2& p);

std::array<double, 4> bounding_box(const Edge& edge);

/// Area between the edge and the origin, 1/2 integral of x cross dx [mm^2].
double swept_area(const Edge& edge);

/// Angle by which the tangent turns along the edge, without sign [rad].
double turning(const Edge& edge);

/// Angle between the tangents where one edge ends and the next begins [rad], in [0, pi].
double kink(const Edge& from, const Edge& to);

}  // namespace reye::cad
