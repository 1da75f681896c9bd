#include "output/report/drawn_frame.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "base/errors.hpp"

namespace reye::output {

namespace {

/// Edges of all cells, each once.
class Edges {
 public:
  void add(DrawnEdge edge) {
    const auto [entry, fresh] = index_.try_emplace(std::minmax(edge.from, edge.to), edges_.size());
    edge.outline = fresh;
    if (fresh)
      edges_.push_back(edge);
    else
      edges_[entry->second].outline = false;
  }
  std::vector<DrawnEdge> take() { return std::move(edges_); }

 private:
  std::map<std::pair<int, int>, std::size_t> index_;
  std::vector<DrawnEdge> edges_;
};

void add_cell(int type, const vtkIdList& nodes, int body, Edges& edges) {
  const auto count = static_cast<int>(nodes.GetNumberOfIds());
  const auto node = [&](int k) { return static_cast<int>(const_cast<vtkIdList&>(nodes).GetId(k)); };
  if (type == VTK_POLY_LINE) {
    for (int k = 1; k < count; ++k) edges.add({node(k - 1), -1, node(k), body});
    return;
  }
  const bool quadratic = type == VTK_QUADRATIC_TRIANGLE || type == VTK_QUADRATIC_QUAD;
  const int corners = quadratic ? count / 2 : count;
  for (int k = 0; k < corners; ++k)
    edges.add({node(k), quadratic ? node(corners + k) : -1, node((k + 1) % corners), body});
}

[[noreturn]] void damaged(const std::string& path) {
  throw base::InputError({{"dir", "", path + " is damaged: it is not a frame of a run"}});
}

template <class Reader>
vtkNew<Reader> opened(const std::string& path) {
  vtkNew<Reader> reader;
  if (!std::filesystem::is_regular_file(path) || !reader->CanReadFile(path.c_str())) damaged(path);
  vtkObject::GlobalWarningDisplayOff();  // its error is reported below
  reader->SetFileName(path.c_str());
  try {
    reader->Update();
  } catch (const std::exception&) {  // sizes that no memory holds
    damaged(path);
  }
  if (reader->GetErrorCode() != 0 || reader->GetOutput() == nullptr) damaged(path);
  return reader;
}

/// The array of so many rows, all finite.
vtkDataArray& array_of(vtkFieldData& data, const char* name, vtkIdType rows, const std::string& path) {
  auto* array = data.GetArray(name);
  if (!array || array->GetNumberOfTuples() < rows || array->GetNumberOfComponents() < 1) damaged(path);
  for (vtkIdType i = 0; i < rows; ++i)
    if (!std::isfinite(array->GetComponent(i, 0))) damaged(path);
  return *array;
}

base::Points points_of(vtkDataSet& data, const std::string& path) {
  base::Points x;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    x.emplace_back(data.GetPoint(i)[0], data.GetPoint(i)[1]);
    if (!x.back().allFinite()) damaged(path);
  }
  return x;
}

}  // namespace

DrawnFrame read_drawn(const std::string& path) {
  const auto reader = opened<vtkXMLUnstructuredGridReader>(path);
  auto* grid = reader->GetOutput();
  auto& body = array_of(*grid->GetCellData(), "body", grid->GetNumberOfCells(), path);
  DrawnFrame frame{array_of(*grid->GetFieldData(), "TimeValue", 1, path).GetComponent(0, 0), {}, {}};
  frame.x = points_of(*grid, path);
  Edges edges;
  vtkNew<vtkIdList> nodes;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
    grid->GetCellPoints(cell, nodes);
    for (vtkIdType k = 0; k < nodes->GetNumberOfIds(); ++k)
      if (nodes->GetId(k) < 0 || nodes->GetId(k) >= grid->GetNumberOfPoints()) damaged(path);
    add_cell(grid->GetCellType(cell), *nodes, static_cast<int>(body.GetComponent(cell, 0)), edges);
  }
  frame.edges = edges.take();
  return frame;
}

DrawnSurfaces read_drawn_surfaces(const std::string& path) {
  const auto reader = opened<vtkXMLPolyDataReader>(path);
  auto* lines = reader->GetOutput();
  auto& pressure = array_of(*lines->GetPointData(), "pressure_MPa", lines->GetNumberOfPoints(), path);
  auto& depth = array_of(*lines->GetPointData(), "wear_depth_mm", lines->GetNumberOfPoints(), path);
  DrawnSurfaces surfaces{points_of(*lines, path), {}, {}};
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i) {
    surfaces.pressure_MPa.push_back(pressure.GetComponent(i, 0));
    surfaces.wear_depth_mm.push_back(depth.GetComponent(i, 0));
  }
  return surfaces;
}

}  // namespace reye::output
