#pragma once
#include <array>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"

namespace reye::adapt {

using base::Analysis;
using base::Points;
using base::Vec2;

/// A facet of the outline, body on the left of a -> b; in second order the Bezier curve with control point c.
struct Facet {
  int a = -1, b = -1, c = -1;
};

/// Nodes at their places, but the middle node of each quadratic facet at its control point 2 x_c - (x_a + x_b) / 2.
/// The map is linear: it takes displacements, too.
Points control_points(const std::vector<Facet>& facets, Points X);

/// Middle nodes from control points: x_c = (x_a + x_b) / 4 + p_c / 2.
Points middle_nodes(const std::vector<Facet>& facets, Points P);

/// Volume the body loses when the ends of a facet move by da and db: that of the signed quadrilateral
/// (a, b, b + db, a + da), turned about the axis in axisymmetry. Exact; summed from the displacements, so that
/// thin strips keep all their digits.   (README, 1)
double swept_volume(Analysis analysis, const std::array<Vec2, 2>& facet, const std::array<Vec2, 2>& displacement);

/// Volume the body loses along a curve with points a, b and control point c that move by da, db, dc: the integral of
/// (2 pi r) x,t cross x,s over the strip x(t, s) = sum B_j(t) (p_j + s d_j), a polynomial, hence exact.
double swept_volume(Analysis analysis, const std::array<Vec2, 3>& facet, const std::array<Vec2, 3>& displacement);

/// The strip under all `facets` when every node, or control point, moves by factor * step[node].
double strip_volume(Analysis analysis, const Points& X, const std::vector<Facet>& facets, const Points& step,
                    double factor = 1.0);

/// The volume of the strip between the outlines of two meshes that differ in their coordinates alone.
double strip_between(Analysis analysis, const Points& before, const Points& after, const std::vector<Facet>& facets);

/// The factor theta near 1 for which the strip has exactly `volume` > 0, by the secant method down to
/// round-off; NaN when there is none.
double exact_factor(Analysis analysis, const Points& X, const std::vector<Facet>& facets, const Points& step,
                    double volume);

/// Integral of the linear shape function of a's node over the facet a -> b: half its length, in axisymmetry
/// with the weight 2 pi r.   (README, 2)
double nodal_length(Analysis analysis, const Vec2& a, const Vec2& b);

/// Integrals of the Bernstein functions of a, b and control point c over the curve, in axisymmetry with the weight
/// 2 pi r.   (README, 2)
std::array<double, 3> nodal_lengths(Analysis analysis, const std::array<Vec2, 3>& facet);

}  // namespace reye::adapt
