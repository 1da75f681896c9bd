#pragma once
#include "base/analysis.hpp"
#include "mesh/mesh.hpp"

/// The size of strains and rotations of a deformation, for the error of small strain.
namespace reye::fem {

/// Strain and rotation where a body stores its energy: the means over X of |eps|, the largest principal strain in size,
/// and of |omega|, the rotation (u_2,1 - u_1,2) / 2 [rad], weighted by eps : eps. They stay bounded where a corner
/// makes both infinite, and material that only moves rigidly does not count.
struct Distortion {
  double strain = 0.0;
  double rotation = 0.0;

  /// Bound of the relative error of small strain, to first order: strain measures, areas and densities differ by |eps|,
  /// the direction of stress by |omega|; twice their sum, for pressures and energies take these shares together (in
  /// five scenes 1.2 to 7 times the difference from finite strain). It does not detect instabilities, as of a slender
  /// column.
  double error() const { return 2.0 * strain_and_rotation(); }
  double strain_and_rotation() const { return strain + rotation; }
};

/// The distortion of nodal displacements u, one per node [mm]. Zero without strain.
Distortion distortion(const mesh::Mesh& mesh, base::Analysis analysis, const base::Points& u);

}  // namespace reye::fem
