#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>
#include <optional>

#include "cad/import/read_vtu.hpp"
#include "cad/import/vtu_grid.hpp"

namespace reye::cad {

namespace {

std::optional<mesh::SolidKind> solid_kind_of(int vtk_type) {
  if (vtk_type == VTK_TETRA) return mesh::SolidKind::tet4;
  if (vtk_type == VTK_QUADRATIC_TETRA) return mesh::SolidKind::tet10;
  if (vtk_type == VTK_HEXAHEDRON) return mesh::SolidKind::hex8;
  return std::nullopt;
}

/// Corners of the facets that are read; 0: no facet.
int corners_of_kind(int vtk_type) {
  if (vtk_type == VTK_TRIANGLE || vtk_type == VTK_QUADRATIC_TRIANGLE) return 3;
  return vtk_type == VTK_QUAD || vtk_type == VTK_QUADRATIC_QUAD ? 4 : 0;
}

/// A solid being read, with the points that are its nodes.
struct SolidBeingRead {
  RawSolid solid;
  UsedPoints nodes;
};

void add_solid_cell(SolidBeingRead& body, mesh::SolidKind kind, const std::vector<int>& nodes,
                    const std::string& path) {
  RawSolidMesh& mesh = body.solid.mesh;
  if (!mesh.cells.empty() && mesh.kind != kind) refuse(path, "the cells of a body must be of one kind");
  mesh.kind = kind;
  body.nodes.add(nodes);
  mesh::SolidCell& cell = mesh.cells.emplace_back();
  cell.fill(-1);
  std::copy(nodes.begin(), nodes.end(), cell.begin());
}

/// Nodes in the order of the file, and cells by their places.
void place_solid_nodes(SolidBeingRead& body, vtkDataArray& positions) {
  body.nodes.number();
  for (const int node : body.nodes.all()) {
    double x[3];
    positions.GetTuple(node, x);
    body.solid.mesh.nodes.emplace_back(x[0], x[1], x[2]);
  }
  for (mesh::SolidCell& cell : body.solid.mesh.cells)
    for (int& node : cell)
      if (node >= 0) node = body.nodes.place(node);
}

void name_solid_facet(SolidBeingRead& body, const std::vector<int>& nodes, int count, const std::string& name) {
  FacetCorners corners{-1, -1, -1, -1};
  for (int k = 0; k < count; ++k) {
    corners[k] = body.nodes.place(nodes[k]);
    if (corners[k] < 0) return;
  }
  std::sort(corners.begin(), corners.end());
  body.solid.mesh.names[corners].insert(name);
}

}  // namespace

std::vector<RawSolid> read_vtu_solids(const std::string& path) {
  const vtkSmartPointer<vtkUnstructuredGrid> opened = open_vtu(path);
  vtkUnstructuredGrid& grid = *opened;
  const auto body_names = names_in(grid, "body_names"), face_names = names_in(grid, "boundary_names");
  const auto body = values_in(grid, "body", 0), face = values_in(grid, "boundary", -1);
  const auto cells = nodes_of_cells(grid, path);
  vtkDataArray& positions = positions_in(grid, path);
  const auto type = [&](std::size_t c) { return grid.GetCellType(static_cast<vtkIdType>(c)); };
  std::map<int, SolidBeingRead> bodies;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (const auto kind = solid_kind_of(type(c))) add_solid_cell(bodies[body[c]], *kind, cells[c], path);
  if (bodies.empty()) refuse(path, "holds no tetrahedra of 4 or 10 nodes and no hexahedra of 8");
  std::vector<RawSolid> solids;
  for (auto& [index, reading] : bodies) {
    place_solid_nodes(reading, positions);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto name = static_cast<std::size_t>(face[c]);
      const int corners = corners_of_kind(type(c));
      if (corners > 0 && face[c] >= 0 && name < face_names.size() && body[c] == index)
        name_solid_facet(reading, cells[c], corners, face_names[name]);
    }
    const auto own = static_cast<std::size_t>(index);
    reading.solid.label = index >= 0 && own < body_names.size() ? body_names[own] : "";
    reading.solid.group = !reading.solid.label.empty();
    solids.push_back(std::move(reading.solid));
  }
  return solids;
}

}  // namespace reye::cad
