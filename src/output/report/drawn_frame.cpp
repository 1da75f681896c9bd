#include "output/report/drawn_frame.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "output/report/vtk_reading.hpp"

namespace reye::output {

namespace {

/// Edges of all cells, each once.
class Edges {
 public:
  void add(DrawnEdge edge) {
    const auto [first, second] = std::minmax(edge.from, edge.to);
    const auto key = static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint32_t>(second);
    const auto [entry, fresh] = index_.try_emplace(key, edges_.size());
    edge.outline = fresh;
    if (fresh)
      edges_.push_back(edge);
    else
      edges_[entry->second].outline = false;
  }
  std::vector<DrawnEdge> take() { return std::move(edges_); }

 private:
  std::unordered_map<std::uint64_t, std::size_t> index_;  // by the two corners, the smaller first
  std::vector<DrawnEdge> edges_;
};

/// The elements of a grid as they are gathered.
struct Elements {
  Edges edges;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<int>> rigid;

  void add(int type, vtkIdList& nodes, int body) {
    const auto count = static_cast<int>(nodes.GetNumberOfIds());
    const auto node = [&](int k) { return static_cast<int>(nodes.GetId(k)); };
    if (type == VTK_POLY_LINE) {
      rigid.push_back({node(0)});
      for (int k = 1; k < count; ++k) {
        edges.add({node(k - 1), -1, node(k), body});
        rigid.back().push_back(node(k));
      }
      return;
    }
    const bool quadratic = type == VTK_QUADRATIC_TRIANGLE || type == VTK_QUADRATIC_QUAD;
    const int corners = quadratic ? count / 2 : count;
    for (int k = 0; k < corners; ++k)
      edges.add({node(k), quadratic ? node(corners + k) : -1, node((k + 1) % corners), body});
    const int inner = quadratic ? corners : 0;  // the first of the nodes between which the rest of the element lies
    for (int k = 0; k < corners && quadratic; ++k)
      triangles.push_back({node(k), node(corners + k), node(corners + (k + corners - 1) % corners)});
    for (int k = 2; k < corners; ++k) triangles.push_back({node(inner), node(inner + k - 1), node(inner + k)});
  }
};

double time_of(vtkDataSet& data, const std::string& path) {
  return array_of(*data.GetFieldData(), "TimeValue", 1, path).GetComponent(0, 0);
}

base::Points points_of(vtkDataSet& data, const std::string& path) {
  base::Points x;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    const double* at = data.GetPoint(i);
    x.emplace_back(at[0], at[1]);
    if (!x.back().allFinite()) damaged_frame(path);
  }
  return x;
}

}  // namespace

DrawnFrame read_drawn(const std::string& path) {
  const auto reader = opened<vtkXMLUnstructuredGridReader>(path, WantedArrays{{"von_mises"}, {"body"}});
  auto* grid = reader->GetOutput();
  auto& body = array_of(*grid->GetCellData(), "body", grid->GetNumberOfCells(), path);
  auto& mises = array_of(*grid->GetPointData(), "von_mises", grid->GetNumberOfPoints(), path);
  DrawnFrame frame;
  frame.cycle = time_of(*grid, path);
  frame.x = points_of(*grid, path);
  frame.von_mises_MPa = values_of(mises);
  frame.body.assign(frame.x.size(), 0);
  Elements elements;
  vtkNew<vtkIdList> nodes;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
    grid->GetCellPoints(cell, nodes);
    const auto of = static_cast<int>(body.GetComponent(cell, 0));
    for (vtkIdType k = 0; k < nodes->GetNumberOfIds(); ++k) {
      if (nodes->GetId(k) < 0 || nodes->GetId(k) >= grid->GetNumberOfPoints()) damaged_frame(path);
      frame.body[static_cast<std::size_t>(nodes->GetId(k))] = of;
    }
    elements.add(grid->GetCellType(cell), *nodes, of);
  }
  frame.edges = elements.edges.take();
  frame.triangles = std::move(elements.triangles);
  frame.rigid = std::move(elements.rigid);
  return frame;
}

namespace {

/// The lines of a grid whose points follow one another.
std::vector<DrawnLine> lines_of(vtkPolyData& grid, const std::string& path) {
  const auto whole = [&](const char* name) -> vtkDataArray& {
    return array_of(*grid.GetCellData(), name, grid.GetNumberOfLines(), path);
  };
  auto &surface = whole("surface"), &side = whole("side"), &body = whole("body"), &left = whole("body_on_left");
  auto* names = vtkStringArray::SafeDownCast(grid.GetFieldData()->GetAbstractArray("contact_names"));
  std::vector<DrawnLine> lines;
  vtkNew<vtkIdList> ids;
  std::size_t begin = 0;
  for (vtkIdType k = 0; k < grid.GetNumberOfLines(); ++k) {
    grid.GetCellPoints(k, ids);
    const auto end = begin + static_cast<std::size_t>(ids->GetNumberOfIds());
    const auto of = static_cast<vtkIdType>(surface.GetComponent(k, 0));
    if (!names || of < 0 || of >= names->GetNumberOfValues()) damaged_frame(path);
    lines.push_back({names->GetValue(of), side.GetComponent(k, 0) == 0.0, static_cast<int>(body.GetComponent(k, 0)),
                     left.GetComponent(k, 0) != 0.0, begin, end});
    begin = end;
  }
  if (begin != static_cast<std::size_t>(grid.GetNumberOfPoints())) damaged_frame(path);
  return lines;
}

}  // namespace

DrawnSurfaces read_drawn_surfaces(const std::string& path) {
  const auto reader =
      opened<vtkXMLPolyDataReader>(path, WantedArrays{{"reference_position", "pressure_MPa", "wear_depth_mm"},
                                                      {"surface", "side", "body", "body_on_left"}});
  auto& grid = *reader->GetOutput();
  const auto column = [&](const char* name) -> vtkDataArray& {
    return array_of(*grid.GetPointData(), name, grid.GetNumberOfPoints(), path);
  };
  DrawnSurfaces surfaces;
  surfaces.cycle = time_of(grid, path);
  surfaces.x = points_of(grid, path);
  auto& reference = column("reference_position");
  for (vtkIdType i = 0; i < grid.GetNumberOfPoints() && reference.GetNumberOfComponents() > 1; ++i)
    surfaces.X.emplace_back(reference.GetComponent(i, 0), reference.GetComponent(i, 1));
  if (surfaces.X.size() != surfaces.x.size()) damaged_frame(path);
  surfaces.pressure_MPa = values_of(column("pressure_MPa"));
  surfaces.wear_depth_mm = values_of(column("wear_depth_mm"));
  surfaces.lines = lines_of(grid, path);
  return surfaces;
}

}  // namespace reye::output
