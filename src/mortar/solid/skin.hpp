#pragma once
#include <array>
#include <vector>

#include "base/linalg.hpp"
#include "base/space.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Mortar integrals between surfaces in space.
namespace reye::mortar {

using base::Points3;
using base::Vec3;

/// One side of a contact: facets over points of its own numbering. Points of tri6 facets are nodes at corners and
/// Bernstein control points in between, whether positions or displacements. Facets of several bodies may form one side.
struct Skin {
  std::vector<mesh::Facet> facets;  ///< nodes: indices of x
  Points3 x;
  /// Positions on which areas of the secondary side are measured: those of the reference at small strain; empty: x.
  Points3 X{};

  const Points3& measured() const { return X.empty() ? x : X; }
};

/// Multipliers of tri6 facets: one per point, or at the corners alone, each with its share of the control points.
enum class SkinDual { linear, quadratic };

struct SkinOptions {
  double search_mm = 0.0;  ///< facets farther apart along the normal than this are not paired
  SkinDual dual = SkinDual::quadratic;
};

/// The integrals of one contact, per secondary point j (rows) that carries a multiplier psi_j:
///   D_jk = int psi_j N_k, M_jl = int psi_j N_l over the part of the secondary side that faces the primary.
/// Row sums of D and M are equal to round-off, so that forces balance.
struct SkinIntegrals {
  base::SparseMatrix D;  ///< secondary x secondary points; diagonal but beside points without multiplier
  base::SparseMatrix M;  ///< secondary x primary points
  /// T_jl = int W_j N_l >= 0, secondary x primary points: W_j = N_j, and its share of N of points without multiplier,
  /// so that the W add up to one. What the primary side loses by wear is spread by it.
  base::SparseMatrix T;
  base::Vector covered;       ///< int psi_j over the covered part = row sum of D [mm^2]
  base::Vector area;          ///< int N_j over all facets of the secondary side, covered or not [mm^2]
  Points3 normal;             ///< unit, outward of the secondary side, per secondary point
  std::vector<char> carries;  ///< per secondary point: it has a multiplier (covered by at least 1e-3 of its area)
  std::vector<char> covers;   ///< per secondary facet: the primary side covers a part of it
};

struct SkinPairs;

/// Integrals at the present positions, segment-based. Of an edge where groups of facets meet, the normal is the mean of
/// those groups that are covered by the primary side. Throws base::InputError where the search distance is not above
/// zero, base::MeshError where a facet has no area, folds over or names a point that does not exist, base::SolveError
/// where a position is not finite.
SkinIntegrals integrate(const Skin& secondary, const Skin& primary, const SkinOptions& options);

/// Integrals over pairs kept from an earlier call, equal to the last bit; pairs that no longer hold are found again.
/// `fresh`: marks of the secondary facets to integrate again. The others keep the integrals of the last call with these
/// pairs, where those still hold; all are integrated where `fresh` is empty.
SkinIntegrals integrate(const Skin& secondary, const Skin& primary, const SkinOptions& options, SkinPairs& pairs,
                        const std::vector<char>& fresh = {});

}  // namespace reye::mortar
