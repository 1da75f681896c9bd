#pragma once
#include "adapt/solid/skin_strip.hpp"
#include "adapt/solid/worn_skin.hpp"

namespace reye::adapt {

/// Facets whose normals at a node differ by less are one smooth surface there, whatever their groups [rad]: faces of a
/// CAD may be tangent to each other, and elements of first order turn by up to 20 degrees.
inline constexpr double smooth_joint_angle = 0.436332312998582;  // 25 degrees

/// Steps of all nodes for a share of the wear. A corner, or node of first order, moves to where the tangent planes of
/// its smooth surfaces meet, each offset by depth = V / (n . sum_f a_jf), a the `area_shares`; a mid node so that the
/// middle of its edge gets the depth that the Bernstein coefficients give there, along the normal there, and the mean
/// of what its ends do along the surface.   (README, 13)
Points3 skin_steps(const mesh::SolidMesh& mesh, const Points3& X, const FacetsAtNodes& facets_at, const WornSkin& worn,
                   double share);

}  // namespace reye::adapt
