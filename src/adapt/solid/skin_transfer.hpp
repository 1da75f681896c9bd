#pragma once
#include "adapt/transfer/surface_transfer.hpp"
#include "mortar/solid/skin.hpp"

namespace reye::adapt {

/// The fields of `from` on the points of `to`, both made of one named face, of the old and the new mesh; one value per
/// point of the skin, at control points the coefficient of their Bernstein function. A new point, or the middle of the
/// edge of a new control point, belongs to the nearest place of the old surface. Interpolated values there, those of
/// control points so that the middle is right; sums by density, restored; labels of the nearest point. Sums that the
/// new points do not resolve go to the new facets they lie on. The kinds are those of the plane (README, 6 and 19).
SurfaceTransfer carry(const mortar::Skin& from, const std::vector<SurfaceField>& fields, const mortar::Skin& to);

}  // namespace reye::adapt
