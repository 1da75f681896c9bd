#pragma once
#include "base/analysis.hpp"
#include "mesh/mesh.hpp"

/// Where the Gauss points of a mesh lie.
namespace reye::adapt {

/// Points of fem::stiffness_rule, cell by cell; those of cell c are [c * per_cell, (c + 1) * per_cell).
struct GaussPoints {
  int per_cell = 0;
  base::Points x;
  std::vector<double> volume;  ///< weight * det J * (1 or 2 pi r) [mm^2 or mm^3]
};

GaussPoints gauss_points(const mesh::Mesh& mesh, base::Analysis analysis);

}  // namespace reye::adapt
