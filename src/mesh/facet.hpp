#pragma once
#include <array>
#include <numbers>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"

/// Facets of an outline, or of the surface of a contact: their nodes, shape functions, rules and measures. Who
/// integrates over a facet or moves one reads them here.   (README, 5)
namespace reye::mesh {

using base::Points;
using base::Vec2;

/// A straight facet has its two ends; a curved one has a control point between them as well.
enum class LineKind { line2, line3 };

constexpr int node_count(LineKind kind) { return kind == LineKind::line2 ? 2 : 3; }

/// First node, last node and, on a curve, the node between them, else -1; the body lies on the left. A mesh has the
/// middle node of the edge there, a formula in Bernstein functions the control point c = 2 x_mid - (a + b) / 2.
using LineFacet = std::array<int, 3>;

constexpr LineKind kind_of(const LineFacet& facet) { return facet[2] < 0 ? LineKind::line2 : LineKind::line3; }

/// Where the tangents of two facets turn by more at their node, each keeps its own normal; else the node has one.
inline constexpr double smooth_angle = 50.0 * std::numbers::pi / 180.0;

/// N_j(xi), xi in [-1, 1]: hats on a straight facet, Bernstein functions on a curve; none is negative, they add up to
/// one.
template <class T>
std::array<T, 3> facet_functions(LineKind kind, const T& xi) {
  const T a = 0.5 * (1.0 - xi), b = 0.5 * (1.0 + xi);
  if (kind == LineKind::line2) return {a, b, T(0.0)};
  return {a * a, b * b, 2.0 * a * b};
}

/// dN_j/dxi.
template <class T>
std::array<T, 3> facet_slopes(LineKind kind, const T& xi) {
  if (kind == LineKind::line2) return {T(-0.5), T(0.5), T(0.0)};
  const T a = 0.5 * (1.0 - xi), b = 0.5 * (1.0 + xi);
  return {-1.0 * a, b, a - b};
}

/// A point of a rule on [-1, 1].
struct RulePoint {
  double xi, weight;
};

/// Gauss points, exact to degree 5 and 9: for straight facets, and for curves and what has no closed form.
inline constexpr std::array<RulePoint, 3> gauss3{
    {{-0.7745966692414834, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.7745966692414834, 5.0 / 9.0}}};
inline constexpr std::array<RulePoint, 5> gauss5{{{-0.9061798459386640, 0.2369268850561891},
                                                  {-0.5384693101056831, 0.4786286704993665},
                                                  {0.0, 0.5688888888888889},
                                                  {0.5384693101056831, 0.4786286704993665},
                                                  {0.9061798459386640, 0.2369268850561891}}};

/// Values at nodes (positions, displacements, depths), with those of control points in place of those of middle nodes.
template <class V>
std::vector<V> control_points(const std::vector<LineFacet>& facets, std::vector<V> values) {
  for (const auto& [a, b, c] : facets)
    if (c >= 0) values[c] = 2.0 * values[c] - 0.5 * (values[a] + values[b]);
  return values;
}

/// Middle nodes from control points: x_mid = (a + b) / 4 + c / 2.
Points middle_nodes(const std::vector<LineFacet>& facets, Points P);

/// int N_j over a facet with these nodes [mm], in axisymmetry int N_j 2 pi r; in closed form where it is straight.
std::array<double, 3> nodal_shares(LineKind kind, const std::array<Vec2, 3>& x, base::Analysis analysis);

}  // namespace reye::mesh
