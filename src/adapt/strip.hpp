#pragma once
#include <array>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"

namespace reye::adapt {

using base::Analysis;
using base::Points;
using base::Vec2;

/// A facet of the outline, body on the left of a -> b.
struct Facet {
  int a = -1, b = -1;
};

/// Volume the body loses when the ends of a facet move by da and db: that of the signed quadrilateral
/// (a, b, b + db, a + da), turned about the axis in axisymmetry. Exact; summed from the displacements, so that
/// thin strips keep all their digits.   (README, 1)
double swept_volume(Analysis analysis, const std::array<Vec2, 2>& facet, const std::array<Vec2, 2>& displacement);

/// The strip under all `facets` when every node moves by factor * step[node].
double strip_volume(Analysis analysis, const Points& X, const std::vector<Facet>& facets, const Points& step,
                    double factor = 1.0);

/// The factor theta near 1 for which the strip has exactly `volume` > 0, by the secant method down to
/// round-off; NaN when there is none.
double exact_factor(Analysis analysis, const Points& X, const std::vector<Facet>& facets, const Points& step,
                    double volume);

/// Integral of the linear shape function of a's node over the facet a -> b: half its length, in axisymmetry
/// with the weight 2 pi r.   (README, 2)
double nodal_length(Analysis analysis, const Vec2& a, const Vec2& b);

}  // namespace reye::adapt
