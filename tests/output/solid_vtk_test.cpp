#include "output/solid/solid_vtk.hpp"

#include <gtest/gtest.h>
#include <vtk-9.1/vtkCellData.h>
#include <vtk-9.1/vtkDataArray.h>
#include <vtk-9.1/vtkFieldData.h>
#include <vtk-9.1/vtkNew.h>
#include <vtk-9.1/vtkPointData.h>
#include <vtk-9.1/vtkPolyData.h>
#include <vtk-9.1/vtkSmartPointer.h>
#include <vtk-9.1/vtkUnstructuredGrid.h>
#include <vtk-9.1/vtkXMLPolyDataReader.h>
#include <vtk-9.1/vtkXMLUnstructuredGridReader.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/errors.hpp"
#include "base/rotation.hpp"
#include "solid_sample.hpp"

using namespace reye::output;

namespace {

template <class Reader>
auto grid_of(const std::string& xml) {
  vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(xml);
  reader->Update();
  return vtkSmartPointer(reader->GetOutput());
}

auto bodies_of(const reye::sim::SolidFrame& frame) {
  return grid_of<vtkXMLUnstructuredGridReader>(solid_bodies_vtu(frame));
}

}  // namespace

// All bodies stand in one grid as hexahedra and quadratic tetrahedra on their deformed positions.
TEST(SolidVtk, BodiesReadBackDeformed) {
  const auto frame = solid_sample::frame(3.0);
  const auto grid = bodies_of(frame);
  EXPECT_EQ(grid->GetNumberOfPoints(), 12 + 27);
  ASSERT_EQ(grid->GetNumberOfCells(), 2 + 6);
  EXPECT_EQ(grid->GetCellType(0), 12);
  EXPECT_EQ(grid->GetCellType(2), 24);
  EXPECT_EQ(grid->GetCellData()->GetArray("body")->GetComponent(1, 0), 0.0);
  EXPECT_EQ(grid->GetCellData()->GetArray("body")->GetComponent(7, 0), 1.0);
  EXPECT_EQ(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 3.0);
  for (vtkIdType i : {0, 11, 12, 38})
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(grid->GetPoint(i)[axis], grid->GetPointData()->GetArray("reference_position")->GetComponent(i, axis) +
                                             grid->GetPointData()->GetArray("displacement")->GetComponent(i, axis));
  EXPECT_EQ(grid->GetPointData()->GetArray("displacement")->GetComponent(5, 2), -0.5);
}

// The von Mises stress of a pull is the pull, of a shear in any plane sqrt(3) times the shear, of a pressure zero.
TEST(SolidVtk, VonMisesStress) {
  auto frame = solid_sample::frame(0.0);
  auto& stress = frame.bodies[0].stress_MPa;
  stress[0] = {0.0, 5.0, 0.0, 0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < 3; ++k) stress[1 + k][3 + k] = 2.0;
  for (std::size_t k = 0; k < 3; ++k) stress[1 + k][0] = 0.0;
  stress[4] = {-4.0, -4.0, -4.0, 0.0, 0.0, 0.0};
  const auto grid = bodies_of(frame);
  auto* mises = grid->GetPointData()->GetArray("von_mises");
  EXPECT_DOUBLE_EQ(mises->GetComponent(0, 0), 5.0);
  for (int k = 1; k <= 3; ++k) EXPECT_DOUBLE_EQ(mises->GetComponent(k, 0), 2.0 * std::sqrt(3.0)) << k;
  EXPECT_EQ(mises->GetComponent(4, 0), 0.0);
  EXPECT_STREQ(grid->GetPointData()->GetArray("stress")->GetComponentName(5), "XZ");
}

// A rigid body is its skin, without stress.
TEST(SolidVtk, RigidBodyIsItsSkin) {
  auto frame = solid_sample::frame(0.0);
  auto rigid = *solid_sample::upper();
  rigid.cells.clear();
  frame.bodies[1].mesh = std::make_shared<reye::mesh::SolidMesh>(rigid);
  frame.bodies[1].stress_MPa.clear();
  const auto grid = bodies_of(frame);
  ASSERT_EQ(grid->GetNumberOfCells(), 2 + 12);
  EXPECT_EQ(grid->GetCellType(2), 22);
  EXPECT_EQ(grid->GetPointData()->GetArray("von_mises")->GetComponent(20, 0), 0.0);
}

// Contact surfaces read back as they were written; a facet of second order is four triangles over its six nodes.
TEST(SolidVtk, SurfacesReadBack) {
  const reye::support::TemporaryFolder dir;
  const auto frame = solid_sample::frame(2.0);
  atomic_write(dir / "surface.vtp", skins_vtp(frame));
  const auto skins = read_drawn_skins(dir / "surface.vtp");
  EXPECT_EQ(skins.cycle, 2.0);
  ASSERT_EQ(skins.all.size(), 2u);
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& read = skins.all[s];
    const auto& wrote = frame.surfaces[s];
    EXPECT_EQ(read.contact, "pad");
    EXPECT_EQ(read.secondary, s == 0);
    EXPECT_EQ(read.X, wrote.x_mm);
    EXPECT_EQ(read.shear_MPa, wrote.shear_MPa);
    EXPECT_EQ(read.slip_mm, wrote.slip_mm);
    EXPECT_EQ(read.normal, wrote.normal);
    EXPECT_EQ(read.pressure_MPa, wrote.pressure_MPa);
    EXPECT_EQ(read.area_mm2, wrote.area_mm2);
    EXPECT_EQ(read.status, wrote.status);
    EXPECT_EQ(read.facets.size(), s == 0 ? 2u : 8u);
    double area = 0.0;  // of the polygons, as fans
    for (const auto& f : read.facets)
      for (std::size_t k = 2; k < f.size(); ++k)
        area += 0.5 * (read.X[f[k - 1]] - read.X[f[0]]).cross(read.X[f[k]] - read.X[f[0]]).norm();
    EXPECT_NEAR(area, 2.0, 1e-12);
  }
}

// Vectors of a body that has turned are written in space, and read back as they are on X.
TEST(SolidVtk, VectorsOfATurnedBodyAreTurnedBack) {
  const reye::support::TemporaryFolder dir;
  auto frame = solid_sample::frame(2.0);
  const reye::base::Vec3 turn(0.3, -1.2, 0.7);
  const auto straight = frame.surfaces[0];
  frame.surfaces[0].turn_rad.assign(straight.x_mm.size(), turn);
  for (auto* vectors : {&frame.surfaces[0].shear_MPa, &frame.surfaces[0].slip_mm, &frame.surfaces[0].normal})
    for (auto& v : *vectors) v = reye::base::turn_by(turn) * v;
  atomic_write(dir / "surface.vtp", skins_vtp(frame));
  const auto read = read_drawn_skins(dir / "surface.vtp").all[0];
  for (std::size_t i = 0; i < straight.x_mm.size(); ++i) {
    EXPECT_LT((read.shear_MPa[i] - straight.shear_MPa[i]).norm(), 1e-14 * (1.0 + straight.shear_MPa[i].norm()));
    EXPECT_LT((read.slip_mm[i] - straight.slip_mm[i]).norm(), 1e-15);
    EXPECT_LT((read.normal[i] - straight.normal[i]).norm(), 1e-15);
  }
}

// Surfaces stand where their bodies have moved; a frame without bodies shows them on X.
TEST(SolidVtk, SurfacesMoveWithTheirBodies) {
  auto frame = solid_sample::frame(0.0);
  const auto moved = grid_of<vtkXMLPolyDataReader>(skins_vtp(frame));
  EXPECT_EQ(moved->GetPoint(0)[2], 0.5);
  frame.bodies.clear();
  EXPECT_EQ(grid_of<vtkXMLPolyDataReader>(skins_vtp(frame))->GetPoint(0)[2], 1.0);
}

// A file of surfaces that is cut, or of something else, is refused with its name.
TEST(SolidVtk, DamagedSurfacesAreRefused) {
  const reye::support::TemporaryFolder dir;
  const std::string whole = skins_vtp(solid_sample::frame(0.0));
  atomic_write(dir / "cut.vtp", whole.substr(0, whole.size() / 2));
  atomic_write(dir / "other.vtp", "nonsense");
  std::string renamed = whole;
  renamed.replace(renamed.find("surface_points"), 14, "surface_paints");
  atomic_write(dir / "renamed.vtp", renamed);
  for (const char* file : {"cut.vtp", "other.vtp", "missing.vtp", "renamed.vtp"})
    EXPECT_THROW(read_drawn_skins(dir / file), reye::base::InputError) << file;
}
