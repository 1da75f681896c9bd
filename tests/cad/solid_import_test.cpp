#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

#include "solid_support.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace reye;
using namespace reye::cad;
using base::Vec3;

/// The sum of signed volumes of cells by their straight edges.
double volume_of_straight_cells(const mesh::SolidMesh& mesh) {
  double volume = 0.0;
  for (const mesh::SolidCell& cell : mesh.cells) {
    const auto& X = mesh.X;
    volume += (X[cell[1]] - X[cell[0]]).dot((X[cell[2]] - X[cell[0]]).cross(X[cell[3]] - X[cell[0]])) / 6.0;
  }
  return volume;
}

// A quarter of half a ball and a block, in a script with names, must come as second-order meshes with the volumes and
// areas of the CAD, positive Jacobians, and mid nodes of the round face on the sphere.
TEST(solid_import, ball_on_flat_by_script) {
  const SolidGeometry geometry = build_solids(
      solid_options({solid_scene("ball_on_flat/ball_on_flat.geo")}, {solid_body("ball"), solid_body("flat")}));
  ASSERT_EQ(geometry.bodies.size(), 2u);
  const mesh::SolidMesh &ball = geometry.bodies[0], &flat = geometry.bodies[1];
  const double exact = solid_pi * 50.0 * 50.0 * 50.0 / 6.0;  // an eighth of a ball
  EXPECT_NEAR(geometry.facts[0].volume_mm3, exact, 1e-6 * exact);
  EXPECT_NEAR(meshed_volume(ball), exact, 1e-4 * exact);
  EXPECT_NEAR(meshed_volume(flat), 125000.0, 1e-6);
  EXPECT_NEAR(meshed_area(ball, "ball_contact"), solid_pi * 50.0 * 50.0 / 2.0, 0.05);
  EXPECT_NEAR(geometry.facts[0].face_area_mm2.at("ball_contact"), solid_pi * 50.0 * 50.0 / 2.0, 1e-6);
  EXPECT_NEAR(meshed_area(flat, "flat_contact"), 2500.0, 1e-8);
  for (const mesh::SolidMesh& mesh : geometry.bodies) EXPECT_GT(poorest_jacobian(mesh), 0.2);
  for (int f : ball.faces.at("ball_contact"))
    for (int node : ball.skin[f].nodes) EXPECT_NEAR((ball.X[node] - Vec3(0, 0, 50)).norm(), 50.0, 1e-6);
  for (int f : ball.faces.at("ball_sx"))
    for (int node : ball.skin[f].nodes) EXPECT_NEAR(ball.X[node].x(), 0.0, 1e-9);
}

// Mid nodes must lie between their corners in VTK's order, of cells and of facets.
TEST(solid_import, order_of_mid_nodes) {
  const SolidGeometry geometry =
      build_solids(solid_options({solid_scene("ball_on_flat/flat.step")}, {solid_body("flat")}));
  const mesh::SolidMesh& mesh = geometry.bodies[0];
  constexpr int of_cell[6][3] = {{4, 0, 1}, {5, 1, 2}, {6, 0, 2}, {7, 0, 3}, {8, 1, 3}, {9, 2, 3}};
  constexpr int of_facet[3][3] = {{3, 0, 1}, {4, 1, 2}, {5, 2, 0}};
  double farthest = 0.0;
  for (const mesh::SolidCell& cell : mesh.cells)
    for (const auto& [m, a, b] : of_cell)
      farthest = std::max(farthest, (mesh.X[cell[m]] - 0.5 * (mesh.X[cell[a]] + mesh.X[cell[b]])).norm());
  for (const mesh::Facet& facet : mesh.skin)
    for (const auto& [m, a, b] : of_facet)
      farthest =
          std::max(farthest, (mesh.X[facet.nodes[m]] - 0.5 * (mesh.X[facet.nodes[a]] + mesh.X[facet.nodes[b]])).norm());
  EXPECT_LT(farthest, 1e-9);
}

// STEP files must give the same bodies, found by their products' names, as the script they were made from.
TEST(solid_import, step_twins) {
  const SolidGeometry geometry =
      build_solids(solid_options({solid_scene("ball_on_flat/ball.step"), solid_scene("ball_on_flat/flat.step")},
                                 {solid_body("ball"), solid_body("flat", mesh::SolidKind::tet4)}));
  EXPECT_NEAR(geometry.facts[0].volume_mm3, solid_pi * 50.0 * 50.0 * 50.0 / 6.0, 1e-3);
  EXPECT_NEAR(geometry.facts[1].volume_mm3, 125000.0, 1e-3);
  EXPECT_EQ(geometry.bodies[0].kind, mesh::SolidKind::tet10);
  EXPECT_EQ(geometry.bodies[1].kind, mesh::SolidKind::tet4);
  EXPECT_NEAR(volume_of_straight_cells(geometry.bodies[1]), 125000.0, 1e-6);
}

// The three solids of an assembly must be found by their names, each where it is.
TEST(solid_import, assembly) {
  const SolidGeometry geometry =
      build_solids(solid_options({solid_scene("assembly_solid/assembly.step")},
                                 {solid_body("clamp"), solid_body("plate"), solid_body("pin_block")}));
  EXPECT_NEAR(geometry.facts[0].box_mm[2], -20.0, 1e-6);
  EXPECT_NEAR(geometry.facts[0].box_mm[5], -6.0, 0.01);
  EXPECT_NEAR(geometry.facts[1].volume_mm3, 7200.0, 1e-6);
  EXPECT_NEAR(geometry.facts[2].box_mm[5], 10.0, 1e-6);
}

// A solid of which IGES holds only the faces must be closed again, its faces known as planes.
TEST(solid_import, iges_faces) {
  SolidGeometryOptions options = solid_options({solid_data("box_faces.iges")}, {solid_body("box")});
  options.faces = {face_of("top", "box")};
  options.faces[0].type = "plane";
  options.faces[0].nearest_mm = Vec3(1, 1, 5);
  const SolidGeometry geometry = build_solids(options);
  EXPECT_NEAR(geometry.facts[0].volume_mm3, 24.0, 1e-6);
  EXPECT_NEAR(meshed_area(geometry.bodies[0], "top"), 6.0, 1e-9);
}

// A script of gmsh's own kernel must be read, and its element sizes and fields must not count.
TEST(solid_import, own_kernel_of_gmsh) {
  SolidGeometryOptions options = solid_options({solid_data("own_kernel.geo")}, {solid_body("block")});
  options.bodies[0].at = Vec3(1.9, 0.5, 0.5);
  const SolidGeometry geometry = build_solids(options);
  EXPECT_NEAR(geometry.facts[0].volume_mm3, 2.0, 1e-9);
  EXPECT_NEAR(meshed_area(geometry.bodies[0], "bottom"), 2.0, 1e-9);
  EXPECT_LT(geometry.bodies[0].cell_count(), 5000);
}

/// The facets at each edge must be two that run along it in opposite directions.
void expect_closed(const mesh::SolidMesh& mesh) {
  std::set<std::pair<int, int>> runs;
  for (const mesh::Facet& facet : mesh.skin) {
    const int n = mesh::facet_corners(facet.kind);
    for (int k = 0; k < n; ++k) {
      const bool is_new = runs.insert({facet.nodes[k], facet.nodes[(k + 1) % n]}).second;
      EXPECT_TRUE(is_new);
    }
  }
  for (const auto& [a, b] : runs) EXPECT_TRUE(runs.contains({b, a}));
}

// The skin must be closed and face outward, round a hollow, too, and whether the body has cells or is rigid.
TEST(solid_import, skin_faces_outward) {
  const double exact = 4.0 / 3.0 * solid_pi * (1.0 - 0.125);
  for (bool rigid : {false, true}) {
    SolidGeometryOptions options = solid_options({solid_data("touching.geo")}, {solid_body("hollow")});
    options.bodies[0].rigid = rigid;
    const SolidGeometry geometry = build_solids(options);
    const mesh::SolidMesh& mesh = geometry.bodies[0];
    expect_closed(mesh);
    EXPECT_NEAR(meshed_volume(mesh), exact, 1e-3 * exact);
    EXPECT_EQ(mesh.cells.empty(), rigid);
    EXPECT_NEAR(geometry.facts[0].volume_mm3, exact, 1e-9);
    for (const mesh::Facet& facet : mesh.skin) {
      const Vec3 a = mesh.X[facet.nodes[0]], b = mesh.X[facet.nodes[1]], c = mesh.X[facet.nodes[2]];
      const Vec3 radial = (a + b + c) / 3.0 - Vec3(5, 0, 0);
      EXPECT_GT((b - a).cross(c - a).dot(radial.norm() > 0.75 ? radial : Vec3(-radial)), 0.0);
    }
  }
}

// Solids that touch must stay two bodies with nodes of their own.
TEST(solid_import, touching_solids_stay_apart) {
  const SolidGeometry geometry =
      build_solids(solid_options({solid_data("touching.geo")}, {solid_body("lower"), solid_body("upper")}));
  for (const mesh::SolidMesh& mesh : geometry.bodies) {
    EXPECT_NEAR(meshed_volume(mesh), 1.0, 1e-9);
    EXPECT_EQ(std::count_if(mesh.X.begin(), mesh.X.end(), [](const Vec3& p) { return std::abs(p.z()) < 1e-9; }) > 30,
              true);
  }
}

// Volumes of one physical group must be one body without a skin between them.
TEST(solid_import, volumes_of_one_group) {
  const SolidGeometry geometry = build_solids(solid_options({solid_data("one_body.geo")}, {solid_body("both")}));
  EXPECT_NEAR(meshed_volume(geometry.bodies[0]), 2.0, 1e-9);
  expect_closed(geometry.bodies[0]);
}

// Equal input must give the same mesh to the last bit.
TEST(solid_import, repeats) {
  const SolidGeometryOptions options =
      solid_options({solid_scene("ball_on_flat/ball_on_flat.geo")}, {solid_body("flat"), solid_body("ball")});
  const SolidGeometry one = build_solids(options), two = build_solids(options);
  for (int b : {0, 1}) {
    EXPECT_EQ(one.bodies[b].X, two.bodies[b].X);
    EXPECT_EQ(one.bodies[b].cells, two.bodies[b].cells);
  }
}

// A file must give the same mesh to the last bit in every folder, however long its name and deep its place, and
// whatever stands in the environment: gmsh orders sets by addresses of memory, which texts before them move.
TEST(solid_import, repeats_in_every_folder) {
  namespace fs = std::filesystem;
  const support::TemporaryFolder root;
  const char* const home = std::getenv("HOME");
  const std::string home_before = home ? home : "/";
  std::vector<SolidGeometry> found;
  for (const std::string& place : {std::string("a"), std::string("b/c/d/e"), std::string(120, 'f') + "/of a part"}) {
    const fs::path folder = fs::path(root.path()) / place;
    fs::create_directories(folder);
    for (const char* file : {"ball_on_flat.geo", "flat.step"})
      fs::copy_file(solid_scene(std::string("ball_on_flat/") + file), folder / file);
    ::setenv("HOME", folder.c_str(), 1);
    for (const auto& [file, body] : {std::pair("ball_on_flat.geo", "ball"), std::pair("flat.step", "flat")}) {
      auto options = solid_options({(folder / file).string()}, {solid_body(body)});
      options.folder = folder.string();
      found.push_back(build_solids(options));
    }
  }
  ::setenv("HOME", home_before.c_str(), 1);
  for (std::size_t k = 2; k < found.size(); ++k) {
    EXPECT_EQ(found[k].bodies[0].X, found[k % 2].bodies[0].X) << k;
    EXPECT_EQ(found[k].bodies[0].cells, found[k % 2].bodies[0].cells) << k;
  }
}

// A script in a folder behind a link must find what it includes from the folder of the scene.
TEST(solid_import, script_behind_a_link) {
  namespace fs = std::filesystem;
  const support::TemporaryFolder root;
  const fs::path scene = root.path() / "scene", cad = root.path() / "other" / "cad";
  for (const fs::path& folder : {scene, cad}) fs::create_directories(folder);
  fs::create_directory_symlink(cad, scene / "link");
  std::ofstream(scene / "common.geo") << "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n";
  std::ofstream(cad / "part.geo") << "Include \"" << (scene / "common.geo").string()
                                  << "\";\nPhysical Volume(\"part\") = {1};\n";
  auto options = solid_options({(scene / "link" / "part.geo").string()}, {solid_body("part")});
  options.folder = scene.string();
  EXPECT_NEAR(meshed_volume(build_solids(options).bodies[0]), 1.0, 1e-9);
}

// Meshes of tetrahedra and hexahedra must be taken as they are, with the names of volumes and surfaces.
TEST(solid_import, meshes_of_files) {
  const SolidGeometry hexahedra = build_solids(solid_options({solid_data("hex8.msh")}, {solid_body("block")}));
  EXPECT_EQ(hexahedra.bodies[0].kind, mesh::SolidKind::hex8);
  EXPECT_EQ(hexahedra.bodies[0].cell_count(), 2);
  EXPECT_EQ(hexahedra.bodies[0].faces.at("top").size(), 2u);
  EXPECT_NEAR(meshed_volume(hexahedra.bodies[0]), 2.0, 1e-12);
  expect_closed(hexahedra.bodies[0]);
  const SolidGeometry tetrahedra = build_solids(solid_options({solid_data("tet10.msh")}, {solid_body("block")}));
  EXPECT_EQ(tetrahedra.bodies[0].kind, mesh::SolidKind::tet10);
  EXPECT_NEAR(meshed_volume(tetrahedra.bodies[0]), 2.0, 1e-12);
  EXPECT_NEAR(meshed_area(tetrahedra.bodies[0], "bottom"), 2.0, 1e-12);
  EXPECT_GT(poorest_jacobian(tetrahedra.bodies[0]), 0.99);
}

// A .vtu must give its bodies and the faces that its quadrilaterals name; a point must find a body in a mesh.
TEST(solid_import, vtu_of_hexahedra) {
  SolidGeometryOptions options = solid_options({solid_data("hex8.vtu")}, {solid_body("upper"), solid_body("base")});
  options.bodies[1].at = Vec3(0.5, 0.5, 0.9);
  options.faces = {face_of("bottom", "base")};
  options.faces[0].box_mm = std::array{-0.1, -0.1, -0.1, 1.1, 1.1, 0.1};
  const SolidGeometry geometry = build_solids(options);
  EXPECT_NEAR(geometry.facts[0].volume_mm3, 2.0, 1e-12);
  EXPECT_NEAR(geometry.facts[1].volume_mm3, 1.0, 1e-12);
  ASSERT_EQ(geometry.bodies[0].faces.at("top").size(), 1u);
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(geometry.bodies[0].X[geometry.bodies[0].skin[geometry.bodies[0].faces.at("top")[0]].nodes[k]].z(), 3.0);
  EXPECT_NEAR(geometry.facts[1].face_area_mm2.at("bottom"), 1.0, 1e-12);
}

// Every scene's geometry must give sound meshes whose named faces have their areas.
TEST(solid_import, geometry_of_the_scenes) {
  struct Expected {
    const char *file, *body, *face;
    double volume, area;
  };
  const double dovetail = std::numbers::sqrt2 * (5.0 - std::tan(solid_pi / 8.0) / std::numbers::sqrt2) * 5.0;
  for (const Expected& each :
       {Expected{"crossed_cylinders/crossed_cylinders.geo", "upper", "upper_contact", 2000.0 * solid_pi,
                 200.0 * solid_pi},
        Expected{"crossed_cylinders/crossed_cylinders.geo", "lower", "lower_contact", 8000.0 * solid_pi,
                 400.0 * solid_pi},
        Expected{"pin_in_bush/pin_in_bush.geo", "pin", "pin_contact", 7.0 * solid_pi * 9.95 * 9.95,
                 14.0 * solid_pi * 9.95},
        Expected{"pin_in_bush/pin_in_bush.geo", "bush", "bush_contact", 5.0 * solid_pi * 156.0, 100.0 * solid_pi},
        Expected{"dovetail_solid/dovetail.geo", "blade", "blade_contact", 337.5, dovetail}}) {
    const SolidGeometry geometry = build_solids(solid_options({solid_scene(each.file)}, {solid_body(each.body)}));
    EXPECT_NEAR(geometry.facts[0].volume_mm3, each.volume, 1e-3 * each.volume) << each.body;
    EXPECT_NEAR(geometry.facts[0].face_area_mm2.at(each.face), each.area, 1e-6 * each.area) << each.body;
    EXPECT_GT(poorest_jacobian(geometry.bodies[0]), 0.2) << each.body;
    EXPECT_TRUE(geometry.warnings.empty());
  }
}

}  // namespace
