#pragma once
#include <vector>

#include "mortar/solid/facet_functions.hpp"

/// Functions that carry the multipliers of a facet in space. Numbers in brackets refer to the room's README.
namespace reye::mortar {

/// A point of quadrature on a pair of facets.
struct SkinPoint {
  double weight = 0.0;    ///< area of the secondary facet [mm^2]
  Vec2 xi;                ///< on the secondary facet
  int pair = 0;           ///< of the primary facets of this secondary one
  FacetValues N{}, Nm{};  ///< shape functions of the secondary facet and of the primary one
  FacetValues P{};        ///< polynomials that are orthonormal over the covered part; see `orthonormalise`
};

/// Which points of a facet carry no multiplier.
using FacetCut = std::array<bool, mesh::most_facet_nodes>;

/// psi_j = sum_l a_jl P_l, zero for points that are cut; share_jk is the part of N_k that j stands for: one at k = j,
/// and where k is cut, equal parts for the nearest points that are not (the ends of an edge for its control point).
struct Multipliers {
  std::array<FacetValues, mesh::most_facet_nodes> a{}, share{};
};

/// Fills P: as many polynomials as the facet has points, which span the same space as its shape functions, one after
/// the other made orthonormal over the covered part (Gram and Schmidt). Bases over small parts are well conditioned in
/// them.
void orthonormalise(mesh::FacetKind kind, std::vector<SkinPoint>& points);

/// The n points that are not cut get n functions that span what sum_k share_jk N_k spans, with
/// int psi_j N_k = delta_jk int N_j for k not cut; they add up to one: a = D G^-1, G_kl = int N_k P_l.   (README, 9)
/// `points`: with P. Throws base::SolveError where there is no such basis.
Multipliers multipliers(mesh::FacetKind kind, const FacetCut& cut, const std::vector<SkinPoint>& points);

}  // namespace reye::mortar
