#include "cad/import/vtu_grid.hpp"

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
#include <array>
#include <cmath>

#include "cad/part/raw.hpp"

namespace reye::cad {

namespace {

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

/// Nodes of the cells that are read; 0: of other kinds, which are left out.
int nodes_of_kind(int vtk_type) {
  constexpr std::array<std::array<int, 2>, 7> known = {{{VTK_TRIANGLE, 3},
                                                        {VTK_QUAD, 4},
                                                        {VTK_QUADRATIC_TRIANGLE, 6},
                                                        {VTK_QUADRATIC_QUAD, 8},
                                                        {VTK_TETRA, 4},
                                                        {VTK_QUADRATIC_TETRA, 10},
                                                        {VTK_HEXAHEDRON, 8}}};
  for (const auto& [type, nodes] : known)
    if (type == vtk_type) return nodes;
  return 0;
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
  if (const int expected = nodes_of_kind(grid.GetCellType(c));
      expected > 0 && static_cast<int>(nodes.size()) != expected)
    refuse(path, "cell " + std::to_string(c) + " has " + std::to_string(nodes.size()) + " points, its kind " +
                     std::to_string(expected));
  return nodes;
}

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> open_vtu(const std::string& path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  vtkObject::GlobalWarningDisplayOff();  // the error is reported below
  if (!reader->CanReadFile(path.c_str())) refuse(path, "VTK cannot read it");
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkUnstructuredGrid> grid = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || grid->GetNumberOfCells() == 0) refuse(path, "holds no mesh");
  return grid;
}

std::vector<std::string> names_in(vtkUnstructuredGrid& grid, const char* array) {
  std::vector<std::string> names;
  if (auto* list = vtkStringArray::SafeDownCast(grid.GetFieldData()->GetAbstractArray(array)))
    for (vtkIdType i = 0; i < list->GetNumberOfValues(); ++i) names.push_back(list->GetValue(i));
  return names;
}

std::vector<int> values_in(vtkUnstructuredGrid& grid, const char* array, int otherwise) {
  std::vector<int> values(static_cast<std::size_t>(grid.GetNumberOfCells()), otherwise);
  if (auto* list = grid.GetCellData()->GetArray(array); list && list->GetNumberOfTuples() == grid.GetNumberOfCells())
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const double value = list->GetComponent(static_cast<vtkIdType>(i), 0); std::abs(value) < 1e9)
        values[i] = static_cast<int>(value);
  return values;
}

std::vector<std::vector<int>> nodes_of_cells(vtkUnstructuredGrid& grid, const std::string& path) {
  check_offsets(grid, path);
  std::vector<std::vector<int>> cells;
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) cells.push_back(nodes_of_cell(grid, c, path));
  return cells;
}

vtkDataArray& positions_in(vtkUnstructuredGrid& grid, const std::string& path) {
  vtkDataArray* positions = grid.GetPointData()->GetArray("reference_position");
  if (!positions) positions = grid.GetPoints()->GetData();
  if (positions->GetNumberOfComponents() != 3 || positions->GetNumberOfTuples() != grid.GetNumberOfPoints())
    refuse(path, "the positions of points must have three components each");
  return *positions;
}

void UsedPoints::number() {
  std::sort(used_.begin(), used_.end());
  used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
}

int UsedPoints::place(int point) const {
  const auto found = std::lower_bound(used_.begin(), used_.end(), point);
  return found != used_.end() && *found == point ? static_cast<int>(found - used_.begin()) : -1;
}

}  // namespace reye::cad
