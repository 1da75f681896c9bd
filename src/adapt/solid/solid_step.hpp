#pragma once
#include <memory>
#include <string>
#include <vector>

#include "adapt/solid/worn_face.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

class SolidRelocationCache;

struct SolidStepResult {
  std::shared_ptr<const mesh::SolidMesh> mesh;  ///< null when the surface could not follow the wear
  double removed = 0.0;      ///< volume between old and new skin [mm^3], measured on the stored coordinates
  double theta = 1.0;        ///< the factor that made the strip exact; of several parts, the one farthest from 1
  int parts = 1;             ///< sub-steps the motion was split into
  double min_quality = 1.0;  ///< smallest shape of a cell (`worn_quality`); 1 of a rigid body
  std::string failure;       ///< empty; else what the surface ran into, where, and the cause
  std::string poor;  ///< the mesh exists but is not fit for a solve: the element, where it is, its shape, the cause
};

/// Moves the worn faces of a solid inwards along their normals so that the strip between old and new skin has exactly
/// the removed volume, lets plane faces beside them follow in their planes and the inside by a harmonic motion from
/// `born`, the mesh as it was made. No wear returns the same mesh. Rigid bodies have a skin alone. Cells below
/// `least_quality` that have lost their shape make the result `poor`. `cache` keeps the factor of the inside between
/// calls; without it the result is the same to the last bit. Throws base::MeshError where the solid has no such face,
/// std::logic_error where a face has another number of nodes.   (README, 12 to 16)
SolidStepResult evolve_solid(const std::shared_ptr<const mesh::SolidMesh>& mesh, const mesh::SolidMesh& born,
                             const std::vector<WornFace>& worn, double least_quality,
                             SolidRelocationCache* cache = nullptr);

}  // namespace reye::adapt
