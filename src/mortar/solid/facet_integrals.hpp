#pragma once
#include <span>
#include <vector>

#include "mortar/solid/multipliers.hpp"
#include "mortar/solid/plane_facet.hpp"
#include "mortar/solid/skin.hpp"

/// The mortar integrals of one secondary facet in space.
namespace reye::mortar {

/// A facet covered by a smaller share takes no part at all; a point covered by less of its area has no multiplier.
inline constexpr double least_covered = 1e-3;

/// Corners within this part of a facet's size of a line count as on it.
inline constexpr double clip_tolerance = 1e-14;

/// Integrals with one primary point: M_jl = int psi_j N_l, T_jl = int W_j N_l, W_j = sum_k share_jk N_k.
struct SkinColumn {
  int primary = 0;
  FacetValues M{}, T{};
};

/// The integrals of one facet, before they are added up.
struct FacetBlock {
  int facet = -1;         ///< -1: it takes no part
  FacetValues covered{};  ///< int N_j over the covered part
  std::array<FacetValues, mesh::most_facet_nodes> D{};
  std::vector<SkinColumn> columns;
};

/// A facet's points in space as polynomials: where it is, and where its areas are measured.
struct FacetMaps {
  FacetPolynomial<Vec3> x, X;
};

/// Work space for one facet, kept between facets so that nothing is allocated.
struct SkinWorkspace {
  PlaneFacet own, other;
  FacetMaps maps;
  std::vector<SkinPoint> points;
  std::vector<int> pairs;                  ///< primary facets that cover a part, as `SkinPoint::pair` numbers them
  double plane_area = 0.0, covered = 0.0;  ///< of the facet and of its covered part, both in the plane [mm^2]
  std::array<FacetValues, mesh::most_facet_nodes> D{};
  std::vector<SkinColumn> columns;
  std::vector<int> column_of;  ///< primary point -> column, -1
};

/// The sides of a contact, and what integrals over all facets share.
struct SkinSides {
  const Skin& secondary;
  const Skin& primary;
  const Points3& primary_normals;     ///< mean normals of facets
  const Points3& primary_middles;     ///< means of the corners of facets
  const base::Vector& primary_radii;  ///< of spheres round them [mm]
  double search_mm;
};

/// Clips a secondary facet with those opposite and places the points of quadrature. Returns whether it takes part.
/// Throws base::MeshError where the facet has no area or folds over.
bool place_points(const SkinSides& sides, int facet, std::span<const int> opposite, SkinWorkspace& w);

/// int N_j over the covered part, of the placed points.
FacetValues covered_areas(const SkinWorkspace& w);

/// D (row sums those of M) and the columns of M and T from the placed points.
void integrate_points(const SkinSides& sides, const FacetCut& cut, SkinWorkspace& w);

}  // namespace reye::mortar
