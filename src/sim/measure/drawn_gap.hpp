#pragma once
#include "base/errors.hpp"
#include "sim/problem/problem.hpp"

/// Gaps and overlaps of the drawing, and the introduction of an overlap over the first step, as in a shrink fit.
namespace reye::sim {

/// The gap or overlap of the sides of a contact on these shapes.
DrawnGap drawn_gap(const PlacedContact& contact, const std::vector<body::ShapePtr>& shapes);

/// Measures every contact, extends its search to the drawn gap, and lets overlaps in over the first step;
/// where that counts cycles, over a step before it. Returns an issue for each overlap that is too deep for a fit.
std::vector<base::Issue> place_drawn_gaps(Problem& problem);

/// The largest motion by a support of one of the bodies of a contact [mm].
double farthest_way(const Problem& problem, const PlacedContact& contact);

/// The message for sides drawn farther apart than the search: their distance, and how far supports move them.
std::string why_out_of_reach(const Problem& problem, const PlacedContact& contact, double search_mm);

/// "contact fit: drawn overlap of 0.02 mm ...", for the plan: gap or overlap of the drawing, or that its sides touch.
std::string in_words(const Problem& problem, const PlacedContact& contact);

}  // namespace reye::sim
