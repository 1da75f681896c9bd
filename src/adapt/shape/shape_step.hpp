#pragma once
#include <string>
#include <vector>

#include "adapt/shape/worn_boundary.hpp"
#include "base/analysis.hpp"
#include "body/shape.hpp"

namespace reye::adapt {

class RelocationCache;

/// The bound below which a mesh is no longer fit for a solve.
struct QualityBound {
  double min_scaled_jacobian = 0.15;
};

struct ShapeStepResult {
  body::ShapePtr shape;      ///< null when the outline could not follow the wear
  double removed = 0.0;      ///< volume of the strip between old and new outline, measured on the stored coordinates
  double theta = 1.0;        ///< the factor that made the strip exact; of several parts, the one farthest from 1
  double min_quality = 1.0;  ///< smallest scaled Jacobian of the new mesh
  int parts = 1;             ///< sub-steps the motion was split into
  std::string failure;       ///< empty; else what the outline ran into, where, and the cause
  std::string poor;  ///< the shape exists but its mesh is not fit for a solve: the element, where it is, the cause
};

/// Moves the worn boundaries of X inwards along their normals so that the strip between old and new outline
/// has exactly the removed volume, and lets the interior follow by a pseudo-elastic relocation.
/// No wear returns the same shape. `cache` keeps the factor of the relocation between calls; without it the
/// result is the same to the last bit. Throws std::out_of_range when a boundary name is not in the mesh.
ShapeStepResult evolve(const body::ShapePtr& shape, base::Analysis analysis, const std::vector<WornBoundary>& worn,
                       const QualityBound& bound = {}, RelocationCache* cache = nullptr);

}  // namespace reye::adapt
