#include "output/folder/vtk_frames.hpp"

#include <gtest/gtest.h>
#include <vtk-9.1/vtkCellData.h>
#include <vtk-9.1/vtkDataArray.h>
#include <vtk-9.1/vtkFieldData.h>
#include <vtk-9.1/vtkIdList.h>
#include <vtk-9.1/vtkNew.h>
#include <vtk-9.1/vtkPointData.h>
#include <vtk-9.1/vtkPolyData.h>
#include <vtk-9.1/vtkSmartPointer.h>
#include <vtk-9.1/vtkUnstructuredGrid.h>
#include <vtk-9.1/vtkXMLPolyDataReader.h>
#include <vtk-9.1/vtkXMLUnstructuredGridReader.h>

#include "mesh/second_order.hpp"
#include "sample_run.hpp"

using namespace reye::output;

namespace {

template <class Reader>
auto read_back(const std::string& xml) {
  vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(xml);
  reader->Update();
  return vtkSmartPointer(reader->GetOutput());
}

auto read_bodies(const reye::sim::Frame& frame) { return read_back<vtkXMLUnstructuredGridReader>(bodies_vtu(frame)); }

}  // namespace

// All bodies stand in one grid, the rigid one as a polyline, on their deformed positions.
TEST(BodiesVtu, ReadsBackWithAllBodiesDeformed) {
  const auto frame = sample::frame(1000.0);
  const auto grid = read_bodies(frame);
  EXPECT_EQ(grid->GetNumberOfPoints(), 27 + 27 + 4);
  EXPECT_EQ(grid->GetNumberOfCells(), 16 + 16 + 1);
  EXPECT_EQ(grid->GetCellType(0), 9);   // quad
  EXPECT_EQ(grid->GetCellType(32), 4);  // polyline
  EXPECT_EQ(grid->GetCellData()->GetArray("body")->GetComponent(32, 0), 2.0);
  const auto* reference = grid->GetPointData()->GetArray("reference_position");
  for (vtkIdType i : {0, 30, 57}) {
    EXPECT_EQ(grid->GetPoint(i)[0], const_cast<vtkDataArray*>(reference)->GetComponent(i, 0) + 0.25);
  }
  EXPECT_EQ(grid->GetPoint(0)[1], -0.5 - 0.01);
}

// Cells of second order are written as quadratic ones with all their nodes, corners first.
TEST(BodiesVtu, SecondOrder) {
  namespace mesh = reye::mesh;
  mesh::Mesh triangle;
  triangle.kind = mesh::CellKind::tri3;
  triangle.X = {{0, 0}, {1, 0}, {0, 1}};
  triangle.cells = {mesh::cell_of({0, 1, 2})};
  triangle.outline = {{0, 1, 2, 0}};
  reye::sim::Frame frame{.cycle = 0.0, .step = "", .bodies = {}, .surfaces = {}, .bonds = {}};
  frame.bodies.push_back(sample::body_frame("triangle", mesh::to_second_order(triangle), 0.0));
  frame.bodies.push_back(sample::body_frame("block", mesh::to_second_order(sample::block(2, 1, 0.0)), 0.0));
  const auto grid = read_bodies(frame);
  EXPECT_EQ(grid->GetCellType(0), 22);  // quadratic triangle
  EXPECT_EQ(grid->GetCellType(1), 23);  // quadratic quadrilateral
  vtkNew<vtkIdList> nodes;
  for (vtkIdType cell : {0, 1, 2}) {
    grid->GetCellPoints(cell, nodes);
    const vtkIdType corners = cell == 0 ? 3 : 4;
    ASSERT_EQ(nodes->GetNumberOfIds(), 2 * corners);
    for (vtkIdType k = 0; k < corners; ++k) {
      const double *a = grid->GetPoint(nodes->GetId(k)), ax = a[0], ay = a[1];
      const double *b = grid->GetPoint(nodes->GetId((k + 1) % corners)), bx = b[0], by = b[1];
      const double* mid = grid->GetPoint(nodes->GetId(corners + k));
      EXPECT_NEAR(mid[0], 0.5 * (ax + bx), 1e-14);
      EXPECT_NEAR(mid[1], 0.5 * (ay + by), 1e-14);
    }
  }
}

// Every array of the frame is there with the names of its components and exact values.
TEST(BodiesVtu, HasItsArrays) {
  const auto grid = read_bodies(sample::frame(1000.0));
  auto* points = grid->GetPointData();
  EXPECT_EQ(points->GetArray("displacement")->GetNumberOfComponents(), 3);
  auto* stress = points->GetArray("stress");
  const char* names[] = {"XX", "YY", "XY", "ZZ"};
  for (int c = 0; c < 4; ++c) EXPECT_STREQ(stress->GetComponentName(c), names[c]);
  EXPECT_EQ(stress->GetComponent(5, 1), -200.0);
  EXPECT_EQ(stress->GetComponent(57, 1), 0.0);
  EXPECT_NEAR(points->GetArray("von_mises")->GetComponent(5, 0), std::sqrt(0.5 * (1e4 + 1.1e2 * 1.1e2 + 1e2) + 2700.0),
              1e-12);
  EXPECT_NE(points->GetArray("wear_depth_mm"), nullptr);
  EXPECT_EQ(grid->GetFieldData()->GetAbstractArray("body_names")->GetVariantValue(1).ToString(), "pad, upper");
}

// Each frame carries its time in cycles, also where the mesh changes between frames.
TEST(BodiesVtu, TimeAndTopologyMayChange) {
  const auto coarse = read_bodies(sample::frame(1000.0, 4));
  const auto fine = read_bodies(sample::frame(2000.0, 8));
  EXPECT_EQ(coarse->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 1000.0);
  EXPECT_EQ(fine->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 2000.0);
  EXPECT_NE(coarse->GetNumberOfCells(), fine->GetNumberOfCells());
}

// Data stand inline and compressed with 64-bit headers: appended data cannot be opened everywhere.
TEST(BodiesVtu, IsInlineBinary) {
  const std::string xml = bodies_vtu(sample::frame(0.0));
  EXPECT_NE(xml.find("header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\""), std::string::npos);
  EXPECT_NE(xml.find("format=\"binary\""), std::string::npos);
  EXPECT_EQ(xml.find("AppendedData"), std::string::npos);
}

// Surfaces are polylines that move with their bodies and carry the columns of the surface tables.
TEST(SurfacesVtp, ReadsBack) {
  const auto frame = sample::frame(9000.0);
  const auto lines = read_back<vtkXMLPolyDataReader>(surfaces_vtp(frame));
  ASSERT_EQ(lines->GetNumberOfPoints(), 18);
  EXPECT_EQ(lines->GetNumberOfLines(), 2);
  EXPECT_EQ(lines->GetPoint(0)[0], -1.0 + 0.25);
  EXPECT_EQ(lines->GetCellData()->GetArray("side")->GetComponent(1, 0), 1.0);
  for (const char* name : {"pressure_MPa", "shear_MPa", "slip_mm", "wear_depth_mm", "status"})
    EXPECT_NE(lines->GetPointData()->GetArray(name), nullptr) << name;
  EXPECT_EQ(lines->GetPointData()->GetArray("pressure_MPa")->GetComponent(4, 0), frame.surfaces[0].pressure_MPa[4]);
}

// A side on two bodies is drawn as two lines, each moved with its own body.
TEST(SurfacesVtp, PiecesOnTwoBodies) {
  auto frame = sample::frame(0.0);
  auto& side = frame.surfaces[1];
  const auto bar = sample::surface(reye::sim::Side::primary, 2, frame.bodies[2], 0, 2, 0.0);
  const double end = side.arc_length_mm.back();
  const auto count = static_cast<vtkIdType>(frame.surfaces[0].node.size() + side.node.size());
  const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  add(side.body, bar.body);
  add(side.node, bar.node);
  add(side.body_on_left, bar.body_on_left);
  add(side.status, bar.status);
  for (double arc : bar.arc_length_mm) side.arc_length_mm.push_back(end + arc);
  for (auto column : {&reye::sim::SurfaceRecord::x_mm, &reye::sim::SurfaceRecord::y_mm,
                      &reye::sim::SurfaceRecord::pressure_MPa, &reye::sim::SurfaceRecord::shear_MPa,
                      &reye::sim::SurfaceRecord::slip_mm, &reye::sim::SurfaceRecord::wear_depth_mm})
    add(side.*column, bar.*column);
  const auto lines = read_back<vtkXMLPolyDataReader>(surfaces_vtp(frame));
  EXPECT_EQ(lines->GetNumberOfLines(), 3);
  const reye::base::Vec2 moved = frame.bodies[2].mesh->X[1] + frame.bodies[2].u[1];
  EXPECT_NEAR(lines->GetPoint(count + 1)[0], moved.x(), 1e-15);
  EXPECT_NEAR(lines->GetPoint(count + 1)[1], moved.y(), 1e-15);
}

// Times of a series grow strictly even while load steps, which are no cycles, go by.
TEST(FrameTimes, GrowStrictly) {
  const auto times = frame_times({0.0, 0.0, 0.0, 100.0, 100.0, 1e9, 1e9, 2e9});
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GT(times[i], times[i - 1]);
  EXPECT_EQ(times[0], 0.0);
  EXPECT_EQ(times[3], 100.0);
  EXPECT_EQ(times[7], 2e9);
  EXPECT_NEAR(times[4], 100.0, 1e-5);
}
