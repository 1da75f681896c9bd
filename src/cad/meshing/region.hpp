#pragma once
#include <optional>
#include <vector>

#include "cad/meshing/size_field.hpp"
#include "mesh/mesh.hpp"

namespace reye::cad {

/// A closed run of nodes bounding the part still to be meshed, body on the left, first node not repeated.
struct RegionLoop {
  std::vector<int> nodes;
  std::vector<bool> corner;  ///< nodes that must stay corners of coarse elements; at least two
};

/// A mesh in the making: nodes, cells made so far, and the loops round the part left to mesh (outer first).
struct Region {
  Points X;
  mesh::CellKind kind = mesh::CellKind::quad4;
  std::vector<mesh::Cell> cells;
  std::vector<RegionLoop> loops;
};

/// Cells between consecutive rows of nodes, the body on the left of the first row. Triangles get their diagonals in
/// alternation, so that no direction is preferred.
std::vector<mesh::Cell> cells_between(const std::vector<std::vector<int>>& rows, mesh::CellKind kind);

/// Covers a smooth stretch of the outline, from node `first` to node `last` of one loop, with `layers` rows of
/// quadrilaterals (or pairs of triangles) along its normals, `depth` thick altogether, and removes them from the region
/// left to mesh. Changes nothing and returns false where the rows would fold or come near another part of the outline.
bool add_layers(Region& region, int first, int last, int layers, double depth);

/// A place where the outline crosses itself, as it is or (all-quad meshes) with every second node left out.
std::optional<Vec2> crossing(const Region& region);

/// Fills a region of one loop with four corners and as many nodes on opposite sides by a regular grid, blended
/// from its sides. Changes nothing and returns false for any other region, and for a grid of poor or too large cells.
bool add_grid(Region& region, const SizeField& size);

/// Turns inner edges of triangles that are flat between two outline facets, then moves nodes from number `first_free`
/// on, each where that lifts the scaled Jacobian of its worst cell, as long as that is below a half. No cell gets worse
/// than the worst one round the moved node was.
void improve(Region& region, int first_free);

/// Meshes the remaining part by gmsh. The nodes of the loops stay exactly where they are; sizes
/// inside follow the field. All-quad meshes need an even number of nodes between corners.
/// Throws base::MeshError when no algorithm gives cells of one kind with positive Jacobians.
void fill(Region& region, const SizeField& size);

}  // namespace reye::cad
