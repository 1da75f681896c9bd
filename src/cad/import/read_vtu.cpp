#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cad/import/read_vtu.hpp"

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

std::vector<std::string> names_in(vtkUnstructuredGrid& grid, const char* array) {
  std::vector<std::string> names;
  if (auto* list = vtkStringArray::SafeDownCast(grid.GetFieldData()->GetAbstractArray(array)))
    for (vtkIdType i = 0; i < list->GetNumberOfValues(); ++i) names.push_back(list->GetValue(i));
  return names;
}

/// Values of a cell array, `otherwise` where there is none.
std::vector<int> values_in(vtkUnstructuredGrid& grid, const char* array, int otherwise) {
  std::vector<int> values(static_cast<std::size_t>(grid.GetNumberOfCells()), otherwise);
  if (auto* list = grid.GetCellData()->GetArray(array); list && list->GetNumberOfTuples() == grid.GetNumberOfCells())
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const double value = list->GetComponent(static_cast<vtkIdType>(i), 0); std::abs(value) < 1e9)
        values[i] = static_cast<int>(value);
  return values;
}

/// VTK does not check the data of cells, so they are checked here before use: how many there are, and where the nodes
/// of each begin.
void check_offsets(vtkUnstructuredGrid& grid, const std::string& path) {
  constexpr vtkIdType most = 50'000'000;
  const vtkIdType count = grid.GetNumberOfCells();
  if (count > most || grid.GetNumberOfPoints() > most) refuse(path, "holds more than 5e7 points or cells");
  vtkCellArray& all = *grid.GetCells();
  vtkDataArray& offsets = *all.GetOffsetsArray();
  const auto offset = [&](vtkIdType c) { return offsets.GetComponent(c, 0); };
  if (all.GetNumberOfCells() != count || offsets.GetNumberOfTuples() != count + 1 || offset(0) != 0.0)
    refuse(path, "the offsets do not fit the cells");
  for (vtkIdType c = 0; c < count; ++c)
    if (!(offset(c + 1) > offset(c))) refuse(path, "cell " + std::to_string(c) + " has no points, by its offset");
  if (offset(count) != static_cast<double>(all.GetNumberOfConnectivityIds()))
    refuse(path, "the offsets do not fit the connectivity");
}

/// Nodes of one cell, by number in the file; checked likewise.
std::vector<int> nodes_of_cell(vtkUnstructuredGrid& grid, vtkIdType c, const std::string& path) {
  vtkNew<vtkIdList> ids;
  grid.GetCellPoints(c, ids);
  std::vector<int> nodes;
  for (vtkIdType node : *ids) {
    if (node < 0 || node >= grid.GetNumberOfPoints())
      refuse(path, "cell " + std::to_string(c) + " refers to point " + std::to_string(node) + ", which does not exist");
    nodes.push_back(static_cast<int>(node));
  }
  if (const auto kind = kind_of(grid.GetCellType(c));
      kind && static_cast<int>(nodes.size()) != mesh::nodes_per_cell(*kind))
    refuse(path, "cell " + std::to_string(c) + " has " + std::to_string(nodes.size()) + " points, its kind " +
                     std::to_string(mesh::nodes_per_cell(*kind)));
  return nodes;
}

std::vector<std::vector<int>> nodes_of_cells(vtkUnstructuredGrid& grid, const std::string& path) {
  check_offsets(grid, path);
  std::vector<std::vector<int>> cells;
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) cells.push_back(nodes_of_cell(grid, c, path));
  return cells;
}

/// Where the points are: on X where the file says that, else as drawn; three components each.
vtkDataArray& positions_in(vtkUnstructuredGrid& grid, const std::string& path) {
  vtkDataArray* positions = grid.GetPointData()->GetArray("reference_position");
  if (!positions) positions = grid.GetPoints()->GetData();
  if (positions->GetNumberOfComponents() != 3 || positions->GetNumberOfTuples() != grid.GetNumberOfPoints())
    refuse(path, "the positions of points must have three components each");
  return *positions;
}

/// A part being read, with the place of each of its nodes.
struct BodyBeingRead {
  RawPart part;
  bool begun = false;
  std::map<int, int> place;
};

void add_cell(BodyBeingRead& body, mesh::CellKind kind, const std::vector<int>& nodes, const std::string& path) {
  RawMesh& mesh = body.part.mesh;
  if (body.begun && mesh.kind != kind) refuse(path, "the cells of a body must be of one kind");
  body.begun = true;
  mesh.kind = kind;
  for (int node : nodes) body.place[node] = -1;
  mesh::Cell cell = mesh::cell_of({});
  std::copy_n(nodes.begin(), mesh::nodes_per_cell(kind), cell.begin());
  mesh.cells.push_back(cell);
}

/// Nodes in the order of the file, and cells by their places.
void place_nodes(BodyBeingRead& body, vtkDataArray& positions) {
  for (auto& [node, place] : body.place) {
    place = static_cast<int>(body.part.mesh.nodes.size());
    double x[3];
    positions.GetTuple(node, x);
    body.part.mesh.nodes.emplace_back(x[0], x[1], x[2]);
  }
  for (mesh::Cell& cell : body.part.mesh.cells)
    for (int& node : cell)
      if (node >= 0) node = body.place.at(node);
}

/// Names a facet of a body: a cell of a boundary with nodes of its own.
void name_facet(BodyBeingRead& reading, const std::vector<int>& cell, const std::string& name) {
  if (cell.size() < 2) return;
  const auto a = reading.place.find(cell[0]), b = reading.place.find(cell[1]);
  if (a != reading.place.end() && b != reading.place.end())
    reading.part.mesh.names[std::minmax(a->second, b->second)].insert(name);
}

}  // namespace

std::vector<RawPart> read_vtu(const std::string& path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  vtkObject::GlobalWarningDisplayOff();  // the error is reported below
  if (!reader->CanReadFile(path.c_str())) refuse(path, "VTK cannot read it");
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  if (reader->GetErrorCode() != 0 || grid.GetNumberOfCells() == 0) refuse(path, "holds no mesh");
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
