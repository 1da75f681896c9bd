#include "cad/import/read_vtu.hpp"

#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>

#include "cad/import/vtu_grid.hpp"

namespace reye::cad {

namespace {

std::optional<mesh::CellKind> kind_of(int vtk_type) {
  switch (vtk_type) {
    case VTK_TRIANGLE:
      return mesh::CellKind::tri3;
    case VTK_QUAD:
      return mesh::CellKind::quad4;
    case VTK_QUADRATIC_TRIANGLE:
      return mesh::CellKind::tri6;
    case VTK_QUADRATIC_QUAD:
      return mesh::CellKind::quad8;
    default:
      return {};
  }
}

/// A part being read, with the points that are its nodes.
struct BodyBeingRead {
  RawPart part;
  bool begun = false;
  UsedPoints nodes;
};

void add_cell(BodyBeingRead& body, mesh::CellKind kind, const std::vector<int>& nodes, const std::string& path) {
  RawMesh& mesh = body.part.mesh;
  if (body.begun && mesh.kind != kind) refuse(path, "the cells of a body must be of one kind");
  body.begun = true;
  mesh.kind = kind;
  body.nodes.add(nodes);
  mesh::Cell cell = mesh::cell_of({});
  std::copy_n(nodes.begin(), mesh::nodes_per_cell(kind), cell.begin());
  mesh.cells.push_back(cell);
}

/// Nodes in the order of the file, and cells by their places.
void place_nodes(BodyBeingRead& body, vtkDataArray& positions) {
  body.nodes.number();
  for (const int node : body.nodes.all()) {
    double x[3];
    positions.GetTuple(node, x);
    body.part.mesh.nodes.emplace_back(x[0], x[1], x[2]);
  }
  for (mesh::Cell& cell : body.part.mesh.cells)
    for (int& node : cell)
      if (node >= 0) node = body.nodes.place(node);
}

/// Names a facet of a body: a cell of a boundary with nodes of its own.
void name_facet(BodyBeingRead& reading, const std::vector<int>& cell, const std::string& name) {
  if (cell.size() < 2) return;
  const int a = reading.nodes.place(cell[0]), b = reading.nodes.place(cell[1]);
  if (a >= 0 && b >= 0) reading.part.mesh.names[std::minmax(a, b)].insert(name);
}

}  // namespace

std::vector<RawPart> read_vtu(const std::string& path) {
  const vtkSmartPointer<vtkUnstructuredGrid> opened = open_vtu(path);
  vtkUnstructuredGrid& grid = *opened;
  const auto body_names = names_in(grid, "body_names"), boundary_names = names_in(grid, "boundary_names");
  const auto body = values_in(grid, "body", 0), boundary = values_in(grid, "boundary", -1);
  const auto cells = nodes_of_cells(grid, path);
  vtkDataArray& positions = positions_in(grid, path);
  std::map<int, BodyBeingRead> bodies;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (const auto kind = kind_of(grid.GetCellType(static_cast<vtkIdType>(c))))
      add_cell(bodies[body[c]], *kind, cells[c], path);
  std::vector<RawPart> parts;
  for (auto& [index, reading] : bodies) {
    place_nodes(reading, positions);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto name = static_cast<std::size_t>(boundary[c]);
      if (boundary[c] < 0 || name >= boundary_names.size() || body[c] != index) continue;
      name_facet(reading, cells[c], boundary_names[name]);
    }
    const auto own = static_cast<std::size_t>(index);
    reading.part.label = index >= 0 && own < body_names.size() ? body_names[own] : "";
    reading.part.group = !reading.part.label.empty();
    parts.push_back(std::move(reading.part));
  }
  if (parts.empty()) refuse(path, "holds no mesh of triangles or quadrilaterals");
  return parts;
}

}  // namespace reye::cad
