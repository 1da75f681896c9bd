#include "output/folder/vtk_frames.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cmath>

#include "output/folder/vtk_pieces.hpp"

namespace reye::output {

namespace {

void add_field_data(vtkDataSet* data, const sim::Frame& frame) {
  const auto time = make_array<vtkDoubleArray>("TimeValue");
  time->InsertNextValue(frame.cycle);
  const auto names = make_array<vtkStringArray>("body_names");
  for (const auto& body : frame.bodies) names->InsertNextValue(body.name);
  const auto units = make_array<vtkStringArray>("units");
  units->InsertNextValue("mm, MPa, cycles");
  for (vtkAbstractArray* array :
       {static_cast<vtkAbstractArray*>(time.Get()), static_cast<vtkAbstractArray*>(names.Get()),
        static_cast<vtkAbstractArray*>(units.Get())})
    data->GetFieldData()->AddArray(array);
}

VTKCellType vtk_type(mesh::CellKind kind) {
  switch (kind) {
    case mesh::CellKind::tri3:
      return VTK_TRIANGLE;
    case mesh::CellKind::quad4:
      return VTK_QUAD;
    case mesh::CellKind::tri6:
      return VTK_QUADRATIC_TRIANGLE;
    case mesh::CellKind::quad8:
      break;
  }
  return VTK_QUADRATIC_QUAD;
}

double von_mises(const std::array<double, 4>& s) {
  const auto [xx, yy, xy, zz] = s;
  const double normal = (xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx);
  return std::sqrt(0.5 * normal + 3.0 * xy * xy);
}

/// The grid of all bodies while they are appended one after the other.
struct BodyGrid {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points = make_points();
  vtkNew<vtkDoubleArray> displacement = make_array<vtkDoubleArray>("displacement", {"x", "y", "z"});
  vtkNew<vtkDoubleArray> reference = make_array<vtkDoubleArray>("reference_position", {"x", "y", "z"});
  vtkNew<vtkDoubleArray> stress = make_array<vtkDoubleArray>("stress", {"XX", "YY", "XY", "ZZ"});
  vtkNew<vtkDoubleArray> mises = make_array<vtkDoubleArray>("von_mises");
  vtkNew<vtkDoubleArray> plastic = make_array<vtkDoubleArray>("plastic_strain");
  vtkNew<vtkDoubleArray> depth = make_array<vtkDoubleArray>("wear_depth_mm");
  vtkNew<vtkIntArray> body = make_array<vtkIntArray>("body");

  void add_points(const sim::BodyFrame& frame) {
    static constexpr std::array<double, 4> unstressed{};
    const auto& X = frame.mesh->X;
    for (std::size_t i = 0; i < X.size(); ++i) {
      const base::Vec2 u = frame.u.empty() ? base::Vec2(0.0, 0.0) : frame.u.at(i);
      const auto& s = frame.stress_MPa.empty() ? unstressed : frame.stress_MPa.at(i);
      points->InsertNextPoint(X[i].x() + u.x(), X[i].y() + u.y(), 0.0);
      displacement->InsertNextTuple3(u.x(), u.y(), 0.0);
      reference->InsertNextTuple3(X[i].x(), X[i].y(), 0.0);
      stress->InsertNextTuple(s.data());
      mises->InsertNextValue(von_mises(s));
      plastic->InsertNextValue(frame.plastic_strain.empty() ? 0.0 : frame.plastic_strain.at(i));
      depth->InsertNextValue(frame.wear_depth_mm.empty() ? 0.0 : frame.wear_depth_mm.at(i));
    }
  }

  template <class Nodes>
  void add_cell(int type, const Nodes& nodes, std::size_t count, vtkIdType first, int index) {
    vtkNew<vtkIdList> ids;
    for (std::size_t i = 0; i < count; ++i) ids->InsertNextId(first + nodes[i]);
    grid->InsertNextCell(type, ids);
    body->InsertNextValue(index);
  }

  void add(const sim::BodyFrame& frame, int index) {
    const vtkIdType first = points->GetNumberOfPoints();
    add_points(frame);
    const mesh::Mesh& mesh = *frame.mesh;
    const int type = vtk_type(mesh.kind);
    const auto count = static_cast<std::size_t>(mesh::nodes_per_cell(mesh.kind));
    for (const auto& cell : mesh.cells) add_cell(type, cell, count, first, index);
    if (!mesh.cells.empty()) return;
    for (const auto& chain : mesh.outline) add_cell(VTK_POLY_LINE, chain, chain.size(), first, index);
  }
};

struct SurfaceLines {
  vtkNew<vtkPolyData> lines;
  vtkNew<vtkPoints> points = make_points();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> reference = make_array<vtkDoubleArray>("reference_position", {"x", "y", "z"});
  vtkNew<vtkDoubleArray> pressure = make_array<vtkDoubleArray>("pressure_MPa");
  vtkNew<vtkDoubleArray> shear = make_array<vtkDoubleArray>("shear_MPa");
  vtkNew<vtkDoubleArray> slip = make_array<vtkDoubleArray>("slip_mm");
  vtkNew<vtkDoubleArray> depth = make_array<vtkDoubleArray>("wear_depth_mm");
  vtkNew<vtkIntArray> status = make_array<vtkIntArray>("status");
  vtkNew<vtkIntArray> surface = make_array<vtkIntArray>("surface");
  vtkNew<vtkIntArray> side = make_array<vtkIntArray>("side");
  vtkNew<vtkIntArray> body = make_array<vtkIntArray>("body");
  vtkNew<vtkIntArray> left = make_array<vtkIntArray>("body_on_left");

  void add_points(const sim::SurfaceRecord& record, const std::vector<sim::BodyFrame>& bodies) {
    for (std::size_t i = 0; i < record.x_mm.size(); ++i) {
      const auto& u = bodies.at(record.body.at(i)).u;
      const base::Vec2 moved = u.empty() ? base::Vec2(0.0, 0.0) : u.at(record.node.at(i));
      points->InsertNextPoint(record.x_mm[i] + moved.x(), record.y_mm.at(i) + moved.y(), 0.0);
      reference->InsertNextTuple3(record.x_mm[i], record.y_mm[i], 0.0);
      pressure->InsertNextValue(record.pressure_MPa.at(i));
      shear->InsertNextValue(record.shear_MPa.at(i));
      slip->InsertNextValue(record.slip_mm.at(i));
      depth->InsertNextValue(record.wear_depth_mm.at(i));
      status->InsertNextValue(record.status.at(i));
    }
  }

  /// Rows [start, end) of a record, whose first row is the point `first`.
  void add_line(const sim::SurfaceRecord& record, std::size_t start, std::size_t end, vtkIdType first, int index) {
    cells->InsertNextCell(static_cast<int>(end - start));
    for (std::size_t i = start; i < end; ++i) cells->InsertCellPoint(first + static_cast<vtkIdType>(i));
    surface->InsertNextValue(index);
    side->InsertNextValue(record.side == sim::Side::secondary ? 0 : 1);
    body->InsertNextValue(record.body.at(start));
    left->InsertNextValue(record.body_on_left.at(start));
  }

  /// One line per chain: the next one begins where the arc length is repeated.
  void add(const sim::SurfaceRecord& record, const std::vector<sim::BodyFrame>& bodies, int index) {
    const vtkIdType first = points->GetNumberOfPoints();
    add_points(record, bodies);
    const auto& arc = record.arc_length_mm;
    std::size_t start = 0;
    for (std::size_t i = 1; i <= arc.size(); ++i) {
      if (i < arc.size() && arc[i] > arc[i - 1]) continue;
      add_line(record, start, i, first, index);
      start = i;
    }
  }
};

}  // namespace

std::string bodies_vtu(const sim::Frame& frame) {
  BodyGrid all;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) all.add(frame.bodies[i], static_cast<int>(i));
  all.grid->SetPoints(all.points);
  for (vtkDoubleArray* array :
       {all.displacement.Get(), all.reference.Get(), all.stress.Get(), all.mises.Get(), all.depth.Get()})
    all.grid->GetPointData()->AddArray(array);
  const auto yields = [](const sim::BodyFrame& body) { return !body.plastic_strain.empty(); };
  if (std::any_of(frame.bodies.begin(), frame.bodies.end(), yields)) all.grid->GetPointData()->AddArray(all.plastic);
  all.grid->GetCellData()->AddArray(all.body);
  add_field_data(all.grid, frame);
  return written<vtkXMLUnstructuredGridWriter>(all.grid);
}

namespace {

/// The grid of all bodies with the facets of their boundaries, and which boundary a cell belongs to (-1: none).
struct NamedGrid {
  BodyGrid all;
  vtkNew<vtkIntArray> boundary = make_array<vtkIntArray>("boundary");
  vtkNew<vtkStringArray> names = make_array<vtkStringArray>("boundary_names");

  void add(const sim::BodyFrame& frame, int index) {
    const vtkIdType first = all.points->GetNumberOfPoints();
    all.add(frame, index);
    while (boundary->GetNumberOfTuples() < all.grid->GetNumberOfCells()) boundary->InsertNextValue(-1);
    for (const auto& [name, chains] : frame.mesh->boundaries) {
      for (const auto& chain : chains)
        add_facets(chain, static_cast<std::size_t>(mesh::order(frame.mesh->kind)), first, index);
      names->InsertNextValue(name);
    }
  }

  void add_facets(const mesh::Chain& chain, std::size_t step, vtkIdType first, int index) {
    for (std::size_t i = 0; i + step < chain.size(); i += step) {
      const mesh::Cell nodes = mesh::cell_of({chain[i], chain[i + step], chain[i + 1]});  // the mid node comes last
      all.add_cell(step == 1 ? VTK_LINE : VTK_QUADRATIC_EDGE, nodes, step + 1, first, index);
      boundary->InsertNextValue(static_cast<int>(names->GetNumberOfValues()));
    }
  }
};

}  // namespace

std::string mesh_vtu(const sim::Frame& frame) {
  NamedGrid named;
  const auto bodies = make_array<vtkStringArray>("body_names");
  for (std::size_t b = 0; b < frame.bodies.size(); ++b) {
    named.add(frame.bodies[b], static_cast<int>(b));
    bodies->InsertNextValue(frame.bodies[b].name);
  }
  BodyGrid& all = named.all;
  all.grid->SetPoints(all.points);
  all.grid->GetCellData()->AddArray(all.body);
  all.grid->GetCellData()->AddArray(named.boundary);
  all.grid->GetFieldData()->AddArray(bodies);
  all.grid->GetFieldData()->AddArray(named.names);
  return written<vtkXMLUnstructuredGridWriter>(all.grid);
}

std::string surfaces_vtp(const sim::Frame& frame) {
  SurfaceLines all;
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) all.add(frame.surfaces[i], frame.bodies, static_cast<int>(i));
  all.lines->SetPoints(all.points);
  all.lines->SetLines(all.cells);
  for (vtkDoubleArray* array :
       {all.reference.Get(), all.pressure.Get(), all.shear.Get(), all.slip.Get(), all.depth.Get()})
    all.lines->GetPointData()->AddArray(array);
  all.lines->GetPointData()->AddArray(all.status);
  for (vtkIntArray* array : {all.surface.Get(), all.side.Get(), all.body.Get(), all.left.Get()})
    all.lines->GetCellData()->AddArray(array);
  const auto contacts = make_array<vtkStringArray>("contact_names");
  for (const auto& record : frame.surfaces) contacts->InsertNextValue(record.contact);
  all.lines->GetFieldData()->AddArray(contacts);
  add_field_data(all.lines, frame);
  return written<vtkXMLPolyDataWriter>(all.lines);
}

}  // namespace reye::output
