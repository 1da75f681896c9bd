#pragma once
#include <string>
#include <vector>

#include "mesh/solid/solid_quality.hpp"

namespace reye::adapt {

/// Depth worn since the mesh was made, over the height of the cell that lay below then, per node, zero off the skin:
/// the largest of its facets, because an edge that slides along one is worn on the other. Of rigid bodies over the
/// smallest height of the facet.
std::vector<double> wear_in_elements(const mesh::SolidMesh& now, const mesh::SolidMesh& born);

/// ": wear since the mesh was made is ... times the height of the element below", at the worn node nearest to a place,
/// for the end of a failure.
std::string cause(const mesh::SolidMesh& now, const mesh::SolidMesh& born, const mesh::Vec3& place);

/// The shape of a cell of a worn mesh: `mesh::shape_quality`, on curved cells times the smallest share of the Jacobian
/// of the straight cell that is left.
double worn_quality(const mesh::SolidMesh& mesh, int cell);

/// The poorest cell, of shape 1 without cells, and the poorest of those below `bound` that have lost a tenth of their
/// shape since birth, -1: none. A mesh that was poor from the start is no reason to stop.
struct WornCells {
  double least = 1.0;
  mesh::PoorestSolidCell unfit;
};
WornCells worn_cells(const mesh::SolidMesh& now, const mesh::SolidMesh& born, double bound);

/// Why a mesh is no longer fit: its poorest cell, where it is, its shape, and the cause.
std::string poor_cell_report(const mesh::SolidMesh& now, const mesh::SolidMesh& born,
                             const mesh::PoorestSolidCell& poorest, double bound);

}  // namespace reye::adapt
