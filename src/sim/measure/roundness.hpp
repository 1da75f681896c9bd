#pragma once
#include <optional>

#include "sim/problem/problem.hpp"

/// Curvature, facets and stiffness of a pair, for estimates in closed form.
namespace reye::sim {

/// 1 / E* = sum over the deformable sides of (1 - nu^2) / E, in plane stress of 1 / E [MPa].
double effective_modulus(const Problem& problem, const PlacedContact& contact);

/// Turning of the surface at a node between its two facets over their mean length, positive where the body is convex
/// [1/mm]; at an end that of the node beside it, zero for a single facet, empty at corners. Of facets of second order:
/// between chords.
std::optional<double> curvature(const mortar::Surface& surface, int node);

/// Longer one of the facets beside a node, over the order of the facet [mm].
double spacing(const mortar::Surface& surface, int node);

/// Distance of straight facets from the arc of which they are chords, h^2 kappa / 8 [mm]; zero in second order.
double sagitta(const mortar::Surface& surface, int node);

}  // namespace reye::sim
