#pragma once
#include <string>

#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

/// Bounds beyond which a worn solid is remeshed.
struct SolidTriggers {
  double min_quality = 0.15;
  double min_facet_shape = 0.3;
  double size_ratio = 2.5;
  double wear_fraction = 0.5;
};

/// A measured value and where in the body it was found [mm, on X].
struct MeasuredInSpace {
  double value = 0.0;
  mesh::Vec3 at = mesh::Vec3::Zero();
};

/// The state of a mesh after wear since it was made.
struct SolidMeshState {
  MeasuredInSpace quality{1.0};      ///< smallest shape of cells with less than 0.7 of that at birth; 1: none
  MeasuredInSpace facet_shape{1.0};  ///< and of facets of the skin
  MeasuredInSpace size_ratio{1.0};   ///< largest change of the mean edge of a facet, either way, or loss of its height
  MeasuredInSpace wear_fraction{0.0};  ///< largest wear over the height of the element below
};

SolidMeshState measure(const mesh::SolidMesh& worn, const mesh::SolidMesh& born);

/// Why a mesh is no longer fit, in words: value, place and bound of what exceeds its bound by the largest factor. Empty
/// when it is fit. A mesh that was poor from the start is no reason.
std::string why_remesh(const mesh::SolidMesh& worn, const mesh::SolidMesh& born, const SolidTriggers& triggers);

}  // namespace reye::adapt
