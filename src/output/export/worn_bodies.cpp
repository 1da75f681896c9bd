#include "output/export/worn_bodies.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <optional>

#include "base/errors.hpp"
#include "mesh/outline.hpp"
#include "mesh/solid/solid_skin.hpp"
#include "output/report/vtk_reading.hpp"

namespace reye::output {

namespace {

/// A cell of a file, over the nodes of its body.
struct FileCell {
  int type = 0;
  std::vector<int> nodes;
};

struct FileBody {
  std::string name;
  base::Points3 X;
  std::vector<double> depth;
  std::vector<FileCell> cells;
};

/// The cells of all bodies over the points of the file; which body has each point.
std::vector<FileBody> bodies_with_cells(vtkUnstructuredGrid& grid, const std::string& path, std::vector<int>& owner) {
  auto& body = array_of(*grid.GetCellData(), "body", grid.GetNumberOfCells(), path);
  auto* names = vtkStringArray::SafeDownCast(grid.GetFieldData()->GetAbstractArray("body_names"));
  if (!names) damaged_frame(path);
  std::vector<FileBody> bodies(static_cast<std::size_t>(names->GetNumberOfValues()));
  for (std::size_t b = 0; b < bodies.size(); ++b) bodies[b].name = names->GetValue(static_cast<vtkIdType>(b));
  owner.assign(static_cast<std::size_t>(grid.GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> ids;
  for (vtkIdType k = 0; k < grid.GetNumberOfCells(); ++k) {
    const double of = body.GetComponent(k, 0);
    if (!(of >= 0.0 && of < static_cast<double>(bodies.size()))) damaged_frame(path);
    const int b = static_cast<int>(of);
    FileCell cell{grid.GetCellType(k), {}};
    grid.GetCellPoints(k, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      const auto node = static_cast<std::size_t>(ids->GetId(i));
      if (node >= owner.size() || (owner[node] >= 0 && owner[node] != b)) damaged_frame(path);
      owner[node] = b;
      cell.nodes.push_back(static_cast<int>(node));
    }
    bodies[static_cast<std::size_t>(b)].cells.push_back(std::move(cell));
  }
  return bodies;
}

std::vector<FileBody> read_bodies(const std::string& path, bool with_depth) {
  const auto reader =
      opened<vtkXMLUnstructuredGridReader>(path, WantedArrays{{"reference_position", "wear_depth_mm"}, {"body"}});
  auto& grid = *reader->GetOutput();
  std::vector<int> owner, place;
  auto bodies = bodies_with_cells(grid, path, owner);
  auto& X = array_of(*grid.GetPointData(), "reference_position", grid.GetNumberOfPoints(), path);
  if (X.GetNumberOfComponents() != 3) damaged_frame(path);
  auto* depth = with_depth ? &array_of(*grid.GetPointData(), "wear_depth_mm", grid.GetNumberOfPoints(), path) : nullptr;
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const auto row = static_cast<vtkIdType>(i);
    if (owner[i] < 0) damaged_frame(path);
    auto& body = bodies[static_cast<std::size_t>(owner[i])];
    place.push_back(static_cast<int>(body.X.size()));
    body.X.emplace_back(X.GetComponent(row, 0), X.GetComponent(row, 1), X.GetComponent(row, 2));
    if (depth) body.depth.push_back(depth->GetComponent(row, 0));
  }
  for (auto& body : bodies)
    for (auto& cell : body.cells)
      for (int& node : cell.nodes) node = place[static_cast<std::size_t>(node)];
  return bodies;
}

/// The kind of a body's cells by their type and number of nodes; nothing where they are not of one.
template <class Kind>
std::optional<Kind> kind_of(const FileBody& body, const std::vector<std::pair<int, Kind>>& kinds,
                            int (*nodes)(Kind kind)) {
  if (body.cells.empty()) return {};
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const auto& entry) { return entry.first == body.cells.front().type; });
  if (found == kinds.end()) return {};
  const auto fits = [&](const FileCell& cell) {
    return cell.type == found->first && static_cast<int>(cell.nodes.size()) == nodes(found->second);
  };
  return std::all_of(body.cells.begin(), body.cells.end(), fits) ? std::optional(found->second) : std::nullopt;
}

template <std::size_t n>
std::array<int, n> padded(const std::vector<int>& nodes) {
  std::array<int, n> all;
  all.fill(-1);
  std::copy(nodes.begin(), nodes.end(), all.begin());
  return all;
}

WornBody plane_body(FileBody&& body, int index, const std::string& path) {
  static const std::vector<std::pair<int, mesh::CellKind>> kinds{{VTK_TRIANGLE, mesh::CellKind::tri3},
                                                                 {VTK_QUAD, mesh::CellKind::quad4},
                                                                 {VTK_QUADRATIC_TRIANGLE, mesh::CellKind::tri6},
                                                                 {VTK_QUADRATIC_QUAD, mesh::CellKind::quad8}};
  WornBody worn{body.name, index, {}, std::move(body.depth)};
  for (const auto& X : body.X) worn.mesh.X.emplace_back(X.x(), X.y());
  if (const auto kind = kind_of(body, kinds, mesh::nodes_per_cell)) {
    worn.mesh.kind = *kind;
    for (const auto& cell : body.cells) worn.mesh.cells.push_back(padded<mesh::most_cell_nodes>(cell.nodes));
    worn.mesh.outline = mesh::outline_of(worn.mesh.X, *kind, worn.mesh.cells);
    return worn;
  }
  for (auto& cell : body.cells) {
    if (cell.type != VTK_POLY_LINE || !mesh::is_closed(cell.nodes)) damaged_frame(path);
    worn.mesh.outline.push_back(std::move(cell.nodes));
  }
  if (worn.mesh.outline.empty()) damaged_frame(path);
  return worn;
}

WornSolid solid_body(FileBody&& body, int index, const std::string& path) {
  static const std::vector<std::pair<int, mesh::SolidKind>> kinds{{VTK_TETRA, mesh::SolidKind::tet4},
                                                                  {VTK_QUADRATIC_TETRA, mesh::SolidKind::tet10},
                                                                  {VTK_HEXAHEDRON, mesh::SolidKind::hex8}};
  static const std::vector<std::pair<int, mesh::FacetKind>> facets{{VTK_TRIANGLE, mesh::FacetKind::tri3},
                                                                   {VTK_QUAD, mesh::FacetKind::quad4},
                                                                   {VTK_QUADRATIC_TRIANGLE, mesh::FacetKind::tri6}};
  WornSolid worn{body.name, index, {}};
  worn.mesh.X = std::move(body.X);
  if (const auto kind = kind_of(body, kinds, mesh::solid_nodes)) {
    worn.mesh.kind = *kind;
    for (const auto& cell : body.cells) worn.mesh.cells.push_back(padded<mesh::most_solid_nodes>(cell.nodes));
    worn.mesh.skin = mesh::faces_of_one_cell(*kind, worn.mesh.cells);
    return worn;
  }
  const auto kind = kind_of(body, facets, mesh::facet_nodes);
  if (!kind) damaged_frame(path);
  for (const auto& cell : body.cells) worn.mesh.skin.push_back({*kind, padded<mesh::most_facet_nodes>(cell.nodes), 0});
  return worn;
}

template <class Body>
std::vector<Body> read_all(const std::string& path, bool with_depth,
                           Body (*made)(FileBody&&, int, const std::string&)) {
  std::vector<Body> all;
  try {
    for (auto& body : read_bodies(path, with_depth))
      all.push_back(made(std::move(body), static_cast<int>(all.size()), path));
  } catch (const base::MeshError&) {  // cells that no run wrote
    damaged_frame(path);
  }
  return all;
}

}  // namespace

std::vector<WornBody> read_worn_bodies(const std::string& path) { return read_all(path, true, plane_body); }

std::vector<WornSolid> read_worn_solids(const std::string& path) { return read_all(path, false, solid_body); }

}  // namespace reye::output
