#pragma once
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "base/linalg.hpp"
#include "contact/solid/skin_setup.hpp"
#include "mortar/solid/skin_pairs.hpp"

namespace reye::contact {

/// Rows of a contact over all points of the system.
using SkinRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Directions of the system's points that supports hold: per point, orthonormal, at most three.
struct HeldDirections {
  std::array<base::Vec3, 3> d{base::Vec3::Zero(), base::Vec3::Zero(), base::Vec3::Zero()};
  int count = 0;
};

/// The frame of a secondary point. Across the normal it can slide along `free` tangents; the others are held on both
/// sides, as on a plane of symmetry, where no shear acts and the normal lies in that plane.
struct SkinFrame {
  base::Vec3 normal = base::Vec3::Zero();
  std::array<base::Vec3, 2> tangent{base::Vec3::Zero(), base::Vec3::Zero()};
  int free = 2;

  base::Vec3 across(const base::Vec3& v) const;  ///< the part of v along the free tangents
  /// The part of v across the normal, along held tangents, too.
  base::Vec3 tangential(const base::Vec3& v) const;
};

/// The frame with its free tangents turned as little as possible from those of `before`. Which axis a tangent is made
/// from depends on digits of the normal that say nothing: unknowns along the tangents would mean something else from
/// one iteration to the next.
SkinFrame turned_least(SkinFrame frame, const SkinFrame& before);

/// A contact where its sides are at present: integrals and frames, held while a system of equations is solved.
///   covered_j w_j = sum_k Q_jk x_k,  Q = (D, -M)   (w: secondary against primary; the gap is -n.w)
/// With tractions z on the points (z.n the pressure, along the slip where friction acts) the forces are f = -Q^T z.
struct SkinPlace {
  SkinRows Q;
  SkinRows D, M, T;      ///< of `mortar::SkinIntegrals`, where the contact wears
  base::Vector covered;  ///< [mm^2]
  base::Vector area;     ///< with the uncovered part
  std::vector<SkinFrame> frame;
  std::vector<char> carries;
  std::vector<char> covers;  ///< per secondary facet: the primary side covers a part of it

  int count() const { return static_cast<int>(frame.size()); }
};

/// Integrates at the displacements of the system's points (3 numbers each). `held` per point of the system; `pairs` are
/// kept from call to call; facets that `fresh` does not mark keep the integrals of the last call, unless it is empty.
SkinPlace place_skins(const SkinSetup& setup, const base::Vector& displacement, const std::vector<HeldDirections>& held,
                      int points, mortar::SkinPairs& pairs, const std::vector<char>& fresh = {});

/// Puts the frames where the points are at these displacements, and leaves the integrals.
void turn_frames(const SkinSetup& setup, const base::Vector& displacement, const std::vector<HeldDirections>& held,
                 SkinPlace& place);

/// sum_k Q_jk x_k / covered_j per secondary point; zero where nothing is covered.
base::Points3 relative(const SkinPlace& place, const base::Vector& x);

}  // namespace reye::contact
