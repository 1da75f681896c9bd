#pragma once
#include "base/analysis.hpp"
#include "material/elastic_part.hpp"
#include "mesh/mesh.hpp"

namespace reye::fem {

/// The material of the cells of a mesh, and how they deform.
struct Solid {
  material::Material material;
  base::Analysis analysis = base::Analysis::plane_strain;
  base::Kinematics kinematics = base::Kinematics::small;
  bool cure = true;  ///< quad4 in plane strain and axisymmetry: B-bar at small strain, F-bar at finite; else ignored

  bool has_history() const;
  /// Whether the tangent is symmetric, as it always is without F-bar.
  bool symmetric(mesh::CellKind kind) const;
};

}  // namespace reye::fem
