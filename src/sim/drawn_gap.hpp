#pragma once
#include "base/errors.hpp"
#include "sim/problem.hpp"

/// Gaps and overlaps of the drawing, and how an overlap is let in: as a shrink fit is, over the first step.
namespace reye::sim {

/// How the sides of a contact lie to one another on these shapes.
DrawnGap drawn_gap(const PlacedContact& contact, const std::vector<body::ShapePtr>& shapes);

/// Measures every contact, has its search reach what the drawing asks for, and lets overlaps in over the first step;
/// where that counts cycles, over a step before it. An issue for each overlap that is too deep for a fit.
std::vector<base::Issue> place_drawn_gaps(Problem& problem);

/// The farthest that a support moves one of the bodies of a contact [mm].
double farthest_way(const Problem& problem, const PlacedContact& contact);

/// Where sides are drawn farther apart than the search: how far, and by how much what drives them brings them together.
std::string why_out_of_reach(const Problem& problem, const PlacedContact& contact, double search_mm);

/// "contact fit: drawn overlap of 0.02 mm ...", for the plan: gap or overlap of the drawing, or that its sides touch.
std::string in_words(const Problem& problem, const PlacedContact& contact);

}  // namespace reye::sim
