#include "output/solid/solid_vtk.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "base/rotation.hpp"
#include "output/folder/vtk_pieces.hpp"
#include "output/report/vtk_reading.hpp"

namespace reye::output {

namespace {

const Names xyz_names{"x", "y", "z"};

int vtk_type_of(mesh::SolidKind kind) {
  switch (kind) {
    case mesh::SolidKind::tet4:
      return VTK_TETRA;
    case mesh::SolidKind::tet10:
      return VTK_QUADRATIC_TETRA;
    case mesh::SolidKind::hex8:
      break;
  }
  return VTK_HEXAHEDRON;
}

int vtk_type_of(mesh::FacetKind kind) {
  switch (kind) {
    case mesh::FacetKind::tri3:
      return VTK_TRIANGLE;
    case mesh::FacetKind::quad4:
      return VTK_QUAD;
    case mesh::FacetKind::tri6:
      break;
  }
  return VTK_QUADRATIC_TRIANGLE;
}

double von_mises_of(const std::array<double, 6>& s) {
  const auto [xx, yy, zz, xy, yz, zx] = s;
  const double normal = (xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx);
  return std::sqrt(0.5 * normal + 3.0 * (xy * xy + yz * yz + zx * zx));
}

void insert(vtkDoubleArray& array, const base::Vec3& v) { array.InsertNextTuple3(v.x(), v.y(), v.z()); }

void add_frame_data(vtkDataSet* data, const sim::SolidFrame& frame) {
  const auto time = make_array<vtkDoubleArray>("TimeValue");
  time->InsertNextValue(frame.cycle);
  const auto names = make_array<vtkStringArray>("body_names"), units = make_array<vtkStringArray>("units");
  for (const auto& body : frame.bodies) names->InsertNextValue(body.name);
  units->InsertNextValue("mm, MPa, cycles");
  data->GetFieldData()->AddArray(time);
  for (vtkStringArray* array : {names.Get(), units.Get()}) data->GetFieldData()->AddArray(array);
}

/// The grid of all bodies while they are appended one after the other.
struct SolidGrid {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points = make_points();
  vtkNew<vtkDoubleArray> displacement = make_array<vtkDoubleArray>("displacement", xyz_names);
  vtkNew<vtkDoubleArray> reference = make_array<vtkDoubleArray>("reference_position", xyz_names);
  vtkNew<vtkDoubleArray> stress = make_array<vtkDoubleArray>("stress", {"XX", "YY", "ZZ", "XY", "YZ", "XZ"});
  vtkNew<vtkDoubleArray> mises = make_array<vtkDoubleArray>("von_mises");
  vtkNew<vtkIntArray> body = make_array<vtkIntArray>("body");

  void add_points(const sim::SolidFrameBody& frame) {
    static constexpr std::array<double, 6> unstressed{};
    const auto& X = frame.mesh->X;
    for (std::size_t i = 0; i < X.size(); ++i) {
      const base::Vec3 u = frame.u.empty() ? base::Vec3::Zero() : frame.u.at(i);
      const auto& s = frame.stress_MPa.empty() ? unstressed : frame.stress_MPa.at(i);
      points->InsertNextPoint((X[i] + u).eval().data());
      insert(*displacement, u);
      insert(*reference, X[i]);
      stress->InsertNextTuple(s.data());
      mises->InsertNextValue(von_mises_of(s));
    }
  }

  template <class Nodes>
  void add_cell(int type, const Nodes& nodes, int count, vtkIdType first, int index) {
    vtkNew<vtkIdList> ids;
    for (int i = 0; i < count; ++i) ids->InsertNextId(first + nodes[static_cast<std::size_t>(i)]);
    grid->InsertNextCell(type, ids);
    body->InsertNextValue(index);
  }

  void add(const sim::SolidFrameBody& frame, int index) {
    const vtkIdType first = points->GetNumberOfPoints();
    add_points(frame);
    const auto& mesh = *frame.mesh;
    for (const auto& cell : mesh.cells)
      add_cell(vtk_type_of(mesh.kind), cell, mesh::solid_nodes(mesh.kind), first, index);
    if (mesh.cells.empty())
      for (const auto& facet : mesh.skin) add_cell(vtk_type_of(facet.kind), facet.nodes, facet.count(), first, index);
  }
};

/// A facet as polygons without mid nodes.
std::vector<std::vector<int>> plain_parts(const mesh::Facet& f) {
  const auto& n = f.nodes;
  if (f.kind == mesh::FacetKind::tri3) return {{n[0], n[1], n[2]}};
  if (f.kind == mesh::FacetKind::quad4) return {{n[0], n[1], n[2], n[3]}};
  return {{n[0], n[3], n[5]}, {n[3], n[1], n[4]}, {n[5], n[4], n[2]}, {n[3], n[4], n[5]}};
}

struct SkinPolygons {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points = make_points();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> reference = make_array<vtkDoubleArray>("reference_position", xyz_names);
  vtkNew<vtkDoubleArray> pressure = make_array<vtkDoubleArray>("pressure_MPa");
  vtkNew<vtkDoubleArray> shear = make_array<vtkDoubleArray>("shear_MPa", xyz_names);
  vtkNew<vtkDoubleArray> slip = make_array<vtkDoubleArray>("slip_mm", xyz_names);
  vtkNew<vtkDoubleArray> normal = make_array<vtkDoubleArray>("normal", xyz_names);
  vtkNew<vtkDoubleArray> turn = make_array<vtkDoubleArray>("turn_rad", xyz_names);
  vtkNew<vtkDoubleArray> area = make_array<vtkDoubleArray>("area_mm2");
  vtkNew<vtkDoubleArray> depth = make_array<vtkDoubleArray>("wear_depth_mm");
  vtkNew<vtkIntArray> status = make_array<vtkIntArray>("status"), surface = make_array<vtkIntArray>("surface"),
                      side = make_array<vtkIntArray>("side"), body = make_array<vtkIntArray>("body");
  vtkNew<vtkStringArray> names = make_array<vtkStringArray>("contact_names");
  vtkNew<vtkIntArray> sides = make_array<vtkIntArray>("surface_side"),
                      counts = make_array<vtkIntArray>("surface_points");

  void add(const sim::SkinRecord& skin, const std::vector<sim::SolidFrameBody>& bodies, int index) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (std::size_t i = 0; i < skin.x_mm.size(); ++i) {
      points->InsertNextPoint(moved_point(skin, i, bodies).data());
      insert(*reference, skin.x_mm[i]);
      pressure->InsertNextValue(skin.pressure_MPa.at(i));
      insert(*shear, skin.shear_MPa.at(i));
      insert(*slip, skin.slip_mm.at(i));
      insert(*normal, skin.normal.at(i));
      insert(*turn, skin.turn_rad.empty() ? base::Vec3(base::Vec3::Zero()) : skin.turn_rad.at(i));
      area->InsertNextValue(skin.area_mm2.at(i));
      depth->InsertNextValue(skin.wear_depth_mm.at(i));
      status->InsertNextValue(skin.status.at(i));
    }
    for (const auto& facet : skin.facets)
      for (const auto& part : plain_parts(facet)) add_polygon(part, first, skin, index);
    names->InsertNextValue(skin.contact);
    sides->InsertNextValue(skin.side == sim::Side::secondary ? 0 : 1);
    counts->InsertNextValue(static_cast<int>(skin.x_mm.size()));
  }

  /// Where the body of a row is; a frame without bodies shows its surfaces on X.
  static base::Vec3 moved_point(const sim::SkinRecord& skin, std::size_t i,
                                const std::vector<sim::SolidFrameBody>& bodies) {
    if (bodies.empty() || bodies.at(skin.body.at(i)).u.empty()) return skin.x_mm[i];
    return skin.x_mm[i] + bodies.at(skin.body[i]).u.at(skin.node.at(i));
  }

  void add_polygon(const std::vector<int>& nodes, vtkIdType first, const sim::SkinRecord& skin, int index) {
    cells->InsertNextCell(static_cast<int>(nodes.size()));
    for (const int node : nodes) cells->InsertCellPoint(first + node);
    surface->InsertNextValue(index);
    side->InsertNextValue(skin.side == sim::Side::secondary ? 0 : 1);
    body->InsertNextValue(skin.body.at(nodes[0]));
  }
};

}  // namespace

std::string solid_bodies_vtu(const sim::SolidFrame& frame) {
  SolidGrid all;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) all.add(frame.bodies[i], static_cast<int>(i));
  all.grid->SetPoints(all.points);
  for (vtkDoubleArray* array : {all.displacement.Get(), all.reference.Get(), all.stress.Get(), all.mises.Get()})
    all.grid->GetPointData()->AddArray(array);
  all.grid->GetCellData()->AddArray(all.body);
  add_frame_data(all.grid, frame);
  return written<vtkXMLUnstructuredGridWriter>(all.grid);
}

std::string skins_vtp(const sim::SolidFrame& frame) {
  SkinPolygons all;
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) all.add(frame.surfaces[i], frame.bodies, static_cast<int>(i));
  all.data->SetPoints(all.points);
  all.data->SetPolys(all.cells);
  for (vtkDoubleArray* array : {all.reference.Get(), all.pressure.Get(), all.shear.Get(), all.slip.Get(),
                                all.normal.Get(), all.turn.Get(), all.area.Get(), all.depth.Get()})
    all.data->GetPointData()->AddArray(array);
  all.data->GetPointData()->AddArray(all.status);
  for (vtkIntArray* array : {all.surface.Get(), all.side.Get(), all.body.Get()})
    all.data->GetCellData()->AddArray(array);
  all.data->GetFieldData()->AddArray(all.names);
  for (vtkIntArray* array : {all.sides.Get(), all.counts.Get()}) all.data->GetFieldData()->AddArray(array);
  add_frame_data(all.data, frame);
  return written<vtkXMLPolyDataWriter>(all.data);
}

namespace {

/// The arrays of a file of surfaces, each whole.
struct SkinArrays {
  vtkDataArray &X, &pressure, &shear, &slip, &normal, &turn, &area, &depth, &status;

  SkinArrays(vtkPolyData& data, const std::string& path)
      : X(three(data, "reference_position", path)),
        pressure(whole(data, "pressure_MPa", path)),
        shear(three(data, "shear_MPa", path)),
        slip(three(data, "slip_mm", path)),
        normal(three(data, "normal", path)),
        turn(three(data, "turn_rad", path)),
        area(whole(data, "area_mm2", path)),
        depth(whole(data, "wear_depth_mm", path)),
        status(whole(data, "status", path)) {}

  static vtkDataArray& whole(vtkPolyData& data, const char* name, const std::string& path) {
    return array_of(*data.GetPointData(), name, data.GetNumberOfPoints(), path);
  }
  static vtkDataArray& three(vtkPolyData& data, const char* name, const std::string& path) {
    auto& array = whole(data, name, path);
    if (array.GetNumberOfComponents() != 3) damaged_frame(path);
    return array;
  }
};

base::Vec3 row_of(vtkDataArray& array, vtkIdType i) {
  return {array.GetComponent(i, 0), array.GetComponent(i, 1), array.GetComponent(i, 2)};
}

void read_rows(SkinArrays& arrays, vtkIdType first, vtkIdType count, DrawnSkin& skin) {
  for (vtkIdType i = first; i < first + count; ++i) {
    skin.X.push_back(row_of(arrays.X, i));
    const base::Turn back = base::turn_by(-row_of(arrays.turn, i));
    skin.shear_MPa.push_back(back * row_of(arrays.shear, i));
    skin.slip_mm.push_back(back * row_of(arrays.slip, i));
    skin.normal.push_back(back * row_of(arrays.normal, i));
    skin.pressure_MPa.push_back(arrays.pressure.GetComponent(i, 0));
    skin.area_mm2.push_back(arrays.area.GetComponent(i, 0));
    skin.wear_depth_mm.push_back(arrays.depth.GetComponent(i, 0));
    skin.status.push_back(static_cast<int>(arrays.status.GetComponent(i, 0)));
  }
}

/// The polygons of each surface, over its own rows.
void read_facets(vtkPolyData& data, const std::string& path, const std::vector<vtkIdType>& first,
                 std::vector<DrawnSkin>& all) {
  auto& surface = array_of(*data.GetCellData(), "surface", data.GetNumberOfCells(), path);
  vtkNew<vtkIdList> ids;
  for (vtkIdType k = 0; k < data.GetNumberOfCells(); ++k) {
    const double of = surface.GetComponent(k, 0);
    if (!(of >= 0.0 && of < static_cast<double>(all.size()))) damaged_frame(path);
    const auto s = static_cast<std::size_t>(of);
    data.GetCellPoints(k, ids);
    std::vector<int> corners;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      const vtkIdType row = ids->GetId(i) - first[s];
      if (row < 0 || row >= static_cast<vtkIdType>(all[s].X.size())) damaged_frame(path);
      corners.push_back(static_cast<int>(row));
    }
    if (corners.size() != 3 && corners.size() != 4) damaged_frame(path);
    all[s].facets.push_back(std::move(corners));
  }
}

}  // namespace

DrawnSkins read_drawn_skins(const std::string& path) {
  const auto reader = opened<vtkXMLPolyDataReader>(path);
  auto& data = *reader->GetOutput();
  auto& fields = *data.GetFieldData();
  DrawnSkins skins;
  skins.cycle = array_of(fields, "TimeValue", 1, path).GetComponent(0, 0);
  auto* names = vtkStringArray::SafeDownCast(fields.GetAbstractArray("contact_names"));
  if (!names) damaged_frame(path);
  if (names->GetNumberOfValues() == 0) return skins;
  auto &sides = array_of(fields, "surface_side", names->GetNumberOfValues(), path),
       &counts = array_of(fields, "surface_points", names->GetNumberOfValues(), path);
  SkinArrays arrays(data, path);
  std::vector<vtkIdType> first{0};
  for (vtkIdType s = 0; s < names->GetNumberOfValues(); ++s) {
    const auto count = static_cast<vtkIdType>(counts.GetComponent(s, 0));
    if (count < 0 || first.back() + count > data.GetNumberOfPoints()) damaged_frame(path);
    skins.all.push_back({names->GetValue(s), sides.GetComponent(s, 0) == 0.0, {}, {}, {}, {}, {}, {}, {}, {}, {}});
    read_rows(arrays, first.back(), count, skins.all.back());
    first.push_back(first.back() + count);
  }
  read_facets(data, path, first, skins.all);
  return skins;
}

}  // namespace reye::output
