#pragma once
#include "base/analysis.hpp"
#include "mesh/mesh.hpp"

/// How far a deformation is from one of small strain and small rotation.
namespace reye::fem {

/// Where a body stores its energy: the means over X of |eps|, the largest principal strain in size, and of |omega|, the
/// rotation (u_2,1 - u_1,2) / 2 [rad], weighted by eps : eps. Bounded where a corner makes both infinite, and blind to
/// material that only moves along.
struct Distortion {
  double strain = 0.0;
  double rotation = 0.0;

  /// Bound of the relative error of small strain, to first order: strain measures, areas and densities differ by |eps|,
  /// the direction of stress by |omega|; twice their sum, for pressures and energies take these shares together (in
  /// five scenes 1.2 to 7 times the difference from finite strain). Instability, as of a slender column, is not seen.
  double error() const { return 2.0 * strain_and_rotation(); }
  double strain_and_rotation() const { return strain + rotation; }
};

/// Of the nodal displacements u, one per node [mm]. Zero where nothing is strained.
Distortion distortion(const mesh::Mesh& mesh, base::Analysis analysis, const base::Points& u);

}  // namespace reye::fem
