#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <sstream>

#include "base/errors.hpp"
#include "output/export/outline_files.hpp"
#include "output/export/run_frames.hpp"
#include "output/export/stl.hpp"
#include "output/export/worn_off.hpp"
#include "output/folder/csv.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/solid/solid_vtk.hpp"
#include "sample_run.hpp"
#include "solid_sample.hpp"

namespace {

using namespace reye;
using namespace reye::output;
using base::Vec2;
using base::Vec3;

/// The bodies of the sample's frame, of which a node of the flat's upper side is worn, as a file holds them.
std::vector<WornBody> sample_bodies(const support::TemporaryFolder& folder) {
  sim::Frame frame = sample::frame(9000.0, 4);
  auto worn = std::make_shared<mesh::Mesh>(*frame.bodies[0].mesh);
  worn->X[12].y() -= 0.125;  // of the upper row, in its middle
  frame.bodies[0].mesh = worn;
  frame.bodies[0].wear_depth_mm[12] = 0.125;
  const std::string file = (folder.path() / "bodies.vtu").string();
  atomic_write(file, bodies_vtu(frame));
  return read_worn_bodies(file);
}

/// Areas inside the closed runs of points of a table or drawing, by the text that names each run.
std::map<std::string, double> areas_of(const std::map<std::string, std::vector<Vec2>>& loops) {
  std::map<std::string, double> areas;
  for (const auto& [name, x] : loops)
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto &a = x[i], &b = x[(i + 1) % x.size()];
      areas[name] += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  return areas;
}

std::map<std::string, std::vector<Vec2>> loops_of_csv(const std::string& text) {
  std::map<std::string, std::vector<Vec2>> loops;
  std::istringstream lines(text);
  std::string line;
  for (int k = 0; std::getline(lines, line); ++k) {
    if (k < 2) continue;
    const auto cells = csv_cells(line);
    loops[cells.at(0)].emplace_back(csv_number(cells.at(2)), csv_number(cells.at(3)));
  }
  return loops;
}

std::map<std::string, std::vector<Vec2>> loops_of_dxf(const std::string& text) {
  std::map<std::string, std::vector<Vec2>> loops;
  std::istringstream lines(text);
  std::string code, value, entity, layer;
  while (std::getline(lines, code) && std::getline(lines, value)) {
    if (code == "0") entity = value;
    if (code == "8") layer = value;
    if (entity == "VERTEX" && code == "10") loops[layer].emplace_back(csv_number(value), 0.0);
    if (entity == "VERTEX" && code == "20") loops[layer].back().y() = csv_number(value);
  }
  return loops;
}

// Bodies must be read on X, the shape without stress, with outlines whose area is that of the body: a triangle is gone.
TEST(ExportShapes, BodiesOnX) {
  const support::TemporaryFolder folder;
  const auto bodies = sample_bodies(folder);
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[1].name, "pad, upper");
  EXPECT_NEAR(content(bodies[0], base::Analysis::plane_strain), 1.0 - 0.0625, 1e-15);
  EXPECT_NEAR(depth_amount(bodies[0], base::Analysis::plane_strain), 0.125 * std::hypot(0.5, 0.125), 1e-15);
  EXPECT_EQ(bodies[2].mesh.cells.size(), 0u) << "the bar is rigid";
  EXPECT_NEAR(content(bodies[2], base::Analysis::plane_strain), 0.4, 1e-15);
}

// Outlines in csv, dxf and stl must enclose the area of each body to round-off, closed, under its name.
TEST(ExportShapes, AreasInFiles) {
  const support::TemporaryFolder folder;
  const auto bodies = sample_bodies(folder);
  const std::string csv = outline_csv(bodies, {}, false, "a note"), dxf = outline_dxf(bodies, "a note");
  EXPECT_TRUE(csv.starts_with("# a note\nbody,loop,x_mm,y_mm,wear_depth_mm,contact_side\n"));
  EXPECT_TRUE(dxf.starts_with("999\na note\n0\nSECTION\n"));
  EXPECT_TRUE(dxf.ends_with("0\nENDSEC\n0\nEOF\n"));
  const auto in_csv = loops_of_csv(csv), in_dxf = loops_of_dxf(dxf);
  EXPECT_EQ(in_csv.at("flat").front(), in_csv.at("flat").back());
  EXPECT_NE(in_dxf.at("flat").front(), in_dxf.at("flat").back()) << "closed by a flag";
  const double area = content(bodies[0], base::Analysis::plane_strain);
  EXPECT_NEAR(areas_of(in_csv).at("flat"), area, 1e-15);
  EXPECT_NEAR(areas_of(in_dxf).at("flat"), area, 1e-11);
  EXPECT_NEAR(areas_of(in_dxf).at("pad__upper"), 1.0, 1e-11);
  EXPECT_NEAR(enclosed_volume(extruded(bodies[0], 3.0)), 3.0 * area, 1e-14);
}

// Rows of the table must name the contact side of a node, all sides of one that has several.
TEST(ExportShapes, SidesOfContacts) {
  const support::TemporaryFolder folder;
  auto frame = sample::frame(9000.0, 4);
  frame.surfaces.push_back(frame.surfaces[0]);
  frame.surfaces.back().contact = "other";
  const std::string file = (folder.path() / "surface.vtp").string();
  atomic_write(file, surfaces_vtp(frame));
  const auto sides = side_names(file);
  EXPECT_EQ(sides.at({0, {-1.0, 0.0}}), "pad secondary + other secondary");
  EXPECT_EQ(sides.at({1, {-1.0, 0.0}}), "pad primary");
  EXPECT_EQ(sides.count({0, {-1.0, -0.5}}), 0u);
}

// Layers must have letters that R12 knows, 31 at most, and differ where names differ in others alone.
TEST(ExportShapes, NamesOfLayers) {
  const support::TemporaryFolder folder;
  auto bodies = sample_bodies(folder);
  bodies[0].name = "Gehäuse, ganz außen und mit einem langen Namen";
  bodies[1].name = "Gehäuse, ganz außen und mit einem langen Namen!";
  const auto loops = loops_of_dxf(outline_dxf(bodies, "n"));
  EXPECT_EQ(loops.size(), 3u);
  for (const auto& [layer, x] : loops) EXPECT_LE(layer.size(), 31u) << layer;
}

// The content of an axisymmetric body must be its whole volume, exact on slanted edges.
TEST(ExportShapes, VolumeOfARing) {
  WornBody ring{"ring", 0, sample::block(4, 2, 0.0), {}};
  for (auto& X : ring.mesh.X) X.x() = 2.0 + (X.x() + 1.0) * (1.0 + 0.5 * X.y());  // r from 2 to 4 + y, y from 0 to 0.5
  ring.wear_depth_mm.assign(ring.mesh.X.size(), 0.0);
  ring.wear_depth_mm[12] = 0.01;  // at r = 3.25, between neighbours 0.625 away
  EXPECT_NEAR(content(ring, base::Analysis::axisymmetric), std::numbers::pi * (6.0 + 1.0 + 1.0 / 24.0), 1e-13);
  EXPECT_NEAR(depth_amount(ring, base::Analysis::axisymmetric), 0.01 * 2.0 * std::numbers::pi * 3.25 * 0.625, 1e-15);
}

// Skins of solids must be closed and outward, of every kind of cells: they enclose the volume of the body.
TEST(ExportShapes, SkinsOfSolids) {
  const support::TemporaryFolder folder;
  const std::string file = (folder.path() / "bodies.vtu").string();
  atomic_write(file, solid_bodies_vtu(solid_sample::frame(1.0)));
  const auto solids = read_worn_solids(file);
  ASSERT_EQ(solids.size(), 2u);
  for (const auto& solid : solids) {
    EXPECT_NEAR(content(solid), 2.0, 1e-14) << solid.name;
    EXPECT_NEAR(enclosed_volume(triangles_of(solid)), 2.0, 1e-14) << solid.name;
  }
}

// A binary STL must have 80 bytes of header, the number of triangles, and 50 bytes for each, with outward normals.
TEST(ExportShapes, BytesOfStl) {
  const std::string file = stl({{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 3, 0)}}, std::string(100, 'n'));
  ASSERT_EQ(file.size(), 80u + 4u + 50u);
  EXPECT_EQ(file.substr(0, 80), std::string(80, 'n'));
  std::uint32_t count = 0;
  std::memcpy(&count, file.data() + 80, 4);
  EXPECT_EQ(count, 1u);
  std::array<float, 12> numbers{};
  std::memcpy(numbers.data(), file.data() + 84, sizeof numbers);
  EXPECT_EQ(numbers, (std::array<float, 12>{0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0}));
}

// The last of several frames at a cycle must be chosen; a cycle or frame that does not exist names those there are.
TEST(ExportShapes, ChoiceOfFrames) {
  const std::vector<double> cycles{0.0, 0.0, 100.0, 4000.5};
  EXPECT_EQ(chosen_frame(cycles, {}, {}), 3u);
  EXPECT_EQ(chosen_frame(cycles, 0.0, {}), 1u);
  EXPECT_EQ(chosen_frame(cycles, 100.0 * (1.0 + 1e-12), {}), 2u);
  EXPECT_EQ(chosen_frame(cycles, {}, 0L), 0u);
  const auto refusal = [&](std::optional<double> cycle, std::optional<long> frame) -> std::string {
    try {
      chosen_frame(cycles, cycle, frame);
    } catch (const base::InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(refusal(99.0, {}), "--cycle = 99: the run has no frame there, but at 0, 100, 4000.5");
  EXPECT_EQ(refusal({}, 4L), "--frame = 4: the run has frames 0 to 3");
}

// A frame that is damaged must be refused with its file.
TEST(ExportShapes, DamagedFrames) {
  const support::TemporaryFolder folder;
  const std::string file = (folder.path() / "bodies.vtu").string();
  atomic_write(file, solid_bodies_vtu(solid_sample::frame(1.0)));
  EXPECT_THROW(read_worn_bodies(file), base::InputError) << "tetrahedra are no plane body";
  atomic_write(file, "<VTKFile");
  EXPECT_THROW(read_worn_bodies(file), base::InputError);
  EXPECT_THROW(read_worn_solids((folder.path() / "none.vtu").string()), base::InputError);
}

}  // namespace
