#pragma once
#include <map>
#include <string>

#include "mesh/quality.hpp"

namespace reye::adapt {

/// Depth worn since the mesh was made, over the height of the cell that lay below then, of every outline node; the
/// larger of its two facets, because a corner that slides along one is worn on the other.
std::map<int, double> wear_in_elements(const mesh::Mesh& now, const mesh::Mesh& born);

/// Depth worn since the mesh was made, over the height of the cell that lay below then, at the worn outline node
/// nearest to a place; 0 when nothing has worn.
double wear_in_elements(const mesh::Mesh& now, const mesh::Mesh& born, const base::Vec2& place);

/// ": wear since the mesh was made is ... times the height of the element below", for the end of a failure.
std::string cause(const mesh::Mesh& now, const mesh::Mesh& born, const base::Vec2& place);

/// Why a mesh is no longer fit: its poorest element, where it is, its quality, and the cause.
std::string poor_cell_report(const mesh::Mesh& now, const mesh::Mesh& born, const mesh::PoorestCell& poorest,
                             double bound);

}  // namespace reye::adapt
