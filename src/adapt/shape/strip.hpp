#pragma once
#include <array>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"
#include "mesh/facet.hpp"

namespace reye::adapt {

using base::Analysis;
using base::Points;
using base::Vec2;

using mesh::LineFacet;

/// Volume the body loses when the ends of a facet move by da and db: that of the signed quadrilateral
/// (a, b, b + db, a + da), turned about the axis in axisymmetry. Exact; summed from the displacements, so that
/// thin strips keep all their digits.   (README, 1)
double swept_volume(Analysis analysis, const std::array<Vec2, 2>& facet, const std::array<Vec2, 2>& displacement);

/// Volume the body loses along a curve with points a, b and control point c that move by da, db, dc: the integral of
/// (2 pi r) x,t cross x,s over the strip x(t, s) = sum B_j(t) (p_j + s d_j), a polynomial, hence exact.
double swept_volume(Analysis analysis, const std::array<Vec2, 3>& facet, const std::array<Vec2, 3>& displacement);

/// The strip under all `facets` when every node, or control point, moves by factor * step[node].
double strip_volume(Analysis analysis, const Points& X, const std::vector<LineFacet>& facets, const Points& step,
                    double factor = 1.0);

/// The volume of the strip between the outlines of two meshes that differ in their coordinates alone.
double strip_between(Analysis analysis, const Points& before, const Points& after,
                     const std::vector<LineFacet>& facets);

/// The factor theta near 1 for which the strip has exactly `volume` > 0, by the secant method down to
/// round-off; NaN when there is none.
double exact_factor(Analysis analysis, const Points& X, const std::vector<LineFacet>& facets, const Points& step,
                    double volume);

}  // namespace reye::adapt
