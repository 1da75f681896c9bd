#pragma once
#include "cad/part/edge.hpp"

namespace reye::adapt {

using base::Points;
using base::Vec2;

/// Directions of travel at points of a smooth line: at each that of the circle through it and its neighbours,
/// e0 / h0 + e1 / h1 with unit chords e and their lengths h; at the ends that of the same circle. Exact on circles,
/// second order otherwise. Kept within 30 degrees of both chords, so that a Hermite curve leaves its chord by at most
/// 0.14 of its length. `closed`: first and last point are the same, and smooth.
Points smooth_tangents(const Points& points, bool closed);

/// Estimated distance of the Hermite curve with smooth tangents from the smooth line the points are taken from [mm]:
/// over all facets the largest |kappa_i - kappa_(i+1)| h^2 / 8, the difference of the circles at its two ends in its
/// middle.
double fit_error(const Points& points, bool closed);

/// An edge through points, smooth where its estimated error is at most `tolerance` [mm], else straight from point
/// to point.
cad::Edge fit(cad::EdgeType type, Points points, double tolerance);

}  // namespace reye::adapt
