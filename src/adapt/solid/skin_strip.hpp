#pragma once
#include <vector>

#include "mesh/solid/solid_shape.hpp"

/// The strip between the skin of a solid before and after wear.
namespace reye::adapt {

using base::Points3;
using base::Vec3;

/// Nodes of a facet, or displacements of them, by its own numbering; columns beyond its nodes are zero.
using FacetPoints = Eigen::Matrix<double, 3, mesh::most_facet_nodes>;

/// The values at the nodes of a facet.
FacetPoints points_of(const Points3& values, const mesh::Facet& facet);

/// Volume that the body loses when the nodes of a facet move by d: - int d(xi) . int_0^1 n(xi, t) dt over the facet,
/// n of x + t d a quadratic in t, so that Simpson's rule is exact. Formed from displacements: thin strips keep their
/// digits.   (README, 12)
double swept_volume(mesh::FacetKind kind, const FacetPoints& x, const FacetPoints& d);

/// The strip under `facets` when every node moves by factor * step[node].
double strip_volume(const Points3& X, const std::vector<mesh::Facet>& facets, const Points3& step, double factor = 1.0);

/// The volume between two skins that differ in their coordinates alone; of a closed skin the loss of volume.
double strip_between(const Points3& before, const Points3& after, const std::vector<mesh::Facet>& facets);

/// What each node counts of a facet [mm^2], a column per node: int N_j n dA of tri3 and quad4, which is what its unit
/// displacement sweeps to first order; of tri6 int B_j dA times the normal at the node, with the Bernstein functions of
/// contact and wear, so that depth = volume / share is that of an even layer whatever the curvature.
FacetPoints area_shares(mesh::FacetKind kind, const FacetPoints& x);

/// Smallest height of a facet: twice the area of a triangle over its longest edge, the area of a quadrilateral over
/// its. Of tri6 half of that of its corners, for the sake of its mid nodes.
double smallest_height(mesh::FacetKind kind, const FacetPoints& x);

}  // namespace reye::adapt
