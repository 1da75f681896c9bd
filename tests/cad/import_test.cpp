#include <numbers>

#include "mesh/outline.hpp"
#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

constexpr double plate_area = 12.0 - std::numbers::pi / 4.0;

Geometry plate(const std::string& file) {
  GeometryOptions options;
  options.files = {data(file)};
  options.bodies = {body_at("plate", 3, 1)};
  options.bodies[0].mesh.far_size_mm = 0.1;
  options.boundaries = {boundary("hole", "plate"), boundary("bottom", "plate")};
  options.boundaries[0].box_mm = {0.4, 1.4, 1.6, 2.6};
  options.boundaries[1].nearest_mm = Vec2(2, -1);
  return build(options);
}

class Formats : public testing::TestWithParam<const char*> {};

// Every format must give the plate with a hole its area and the lengths of its edges in mm.
TEST_P(Formats, area_and_lengths) {
  const Geometry geometry = plate(GetParam());
  const mesh::Mesh& mesh = geometry.bodies[0];
  const bool own_mesh = std::string(GetParam()).ends_with(".msh");  // coarser, and it is used as it is
  EXPECT_NEAR(geometry.facts[0].area_mm2, plate_area, own_mesh ? 0.15 : 2e-5);
  EXPECT_NEAR(mesh::area(mesh), plate_area, own_mesh ? 0.15 : 0.01);
  EXPECT_NEAR(mesh::length(mesh.X, mesh.boundaries.at("bottom")), 4.0, 1e-12);
  EXPECT_NEAR(mesh::length(mesh.X, mesh.boundaries.at("hole")), std::numbers::pi, own_mesh ? 0.35 : 0.01);
  ASSERT_EQ(mesh.boundaries.at("hole").size(), 1u);
  EXPECT_TRUE(mesh::is_closed(mesh.boundaries.at("hole")[0]));
  EXPECT_EQ(mesh.outline.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(import, Formats,
                         testing::Values("plate.step", "plate.iges", "plate.brep", "plate.geo", "plate.geo_unrolled",
                                         "plate.msh"));

// A STEP file written in metres must arrive in mm, and the import after it too.
TEST(import, lengths_are_mm_whatever_came_before) {
  GeometryOptions options;
  options.files = {data("plate_in_metres.step"), data("plate.step"), data("plate.iges"), data("plate.brep")};
  options.bodies = {body_at("large", 3000, 1000)};
  EXPECT_NEAR(build(options).facts[0].area_mm2, 1e6 * plate_area, 1.0);
  for (const char* after : {"plate.step", "plate.iges", "plate.brep"})
    EXPECT_NEAR(plate(after).facts[0].area_mm2, plate_area, 1e-6) << after;
}

// Bodies must be found by the product names of a STEP file: as label, or as their own name.
TEST(import, bodies_by_step_product) {
  GeometryOptions options;
  options.files = {data("named.step")};
  options.bodies = {body("punch"), body("base")};
  options.bodies[1].label = "block";
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 4.0, 1e-12);
  EXPECT_NEAR(geometry.facts[1].area_mm2, 12.0, 1e-12);
}

// Faces in parallel tilted planes must be mapped to x-y, keeping lengths and areas.
TEST(import, tilted_faces_are_laid_into_the_plane) {
  GeometryOptions options;
  options.files = {data("tilted.step")};
  options.bodies = {body_at("plate", 3, 1), body_at("copy", 13, 1)};
  const Geometry geometry = build(options);
  for (int b : {0, 1}) {
    EXPECT_NEAR(geometry.facts[b].area_mm2, plate_area, 1e-9);
    const std::array<double, 4> expected{10.0 * b, 0.0, 10.0 * b + 4.0, 3.0};
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(geometry.facts[b].box_mm[k], expected[k], 1e-9);
  }
}

// Faces that do not lie in parallel planes must be refused, naming the one that stands out.
TEST(import, faces_across_each_other_are_refused) {
  GeometryOptions options;
  options.files = {data("named.step"), data("tilted.step")};
  options.bodies = {body("punch")};
  EXPECT_NE(issues_of(options).find("all faces of a scene must lie in parallel planes"), std::string::npos);
}

// Bodies that share a curve in a script must each have nodes and boundary of their own; the faces of one
// physical surface must be one body.
TEST(import, shared_curves_are_doubled) {
  GeometryOptions options;
  options.files = {data("shared_curve.geo")};
  options.bodies = {body("left"), body("right")};
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 1.0, 1e-12);
  EXPECT_NEAR(geometry.facts[1].area_mm2, 2.0, 1e-12);
  for (const mesh::Mesh& mesh : geometry.bodies)
    EXPECT_NEAR(mesh::length(mesh.X, mesh.boundaries.at("interface")), 1.0, 1e-12);
  EXPECT_TRUE(geometry.bodies[0].boundaries.contains("left_end"));
  ASSERT_EQ(geometry.bodies[1].boundaries.at("right_bottom").size(), 1u) << "consecutive curves make one chain";
  EXPECT_NEAR(mesh::length(geometry.bodies[1].X, geometry.bodies[1].boundaries.at("right_bottom")), 2.0, 1e-12);
}

// Control points of splines must not become nodes that belong to no cell, and the curve must be met.
TEST(import, spline_keeps_its_shape_and_leaves_no_orphans) {
  GeometryOptions options;
  options.files = {data("spline.geo")};
  options.bodies = {body("body")};
  options.bodies[0].mesh.far_size_mm = 0.02;
  const Geometry geometry = build(options);  // build checks for orphans
  EXPECT_NEAR(mesh::area(geometry.bodies[0]), geometry.facts[0].area_mm2, 2e-4);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 1.0, 1e-9);  // antisymmetric about y = 1
}

// A mesh that comes with its file must be used as it is, with physical names of bodies and boundaries.
TEST(import, prescribed_mesh_is_kept) {
  GeometryOptions options;
  options.files = {scene_file("patch/two_blocks.msh")};
  options.bodies = {body("upper"), body("lower")};
  options.fine_zones = {{{}, {5, 5}, 1.0, 1.0, 0.01, 0.0}};  // without effect
  const Geometry geometry = build(options);
  EXPECT_EQ(geometry.bodies[0].cell_count(), 25);
  EXPECT_EQ(geometry.bodies[1].cell_count(), 50);
  const mesh::Mesh& lower = geometry.bodies[1];
  std::vector<double> x;
  for (int node : mesh::nodes_of(lower.boundaries.at("lower_top"))) x.push_back(lower.X[node].x());
  const std::vector<double> expected{10, 9.4, 8, 7, 6, 5, 4, 2.8, 2, 1, 0};
  ASSERT_EQ(x.size(), expected.size());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-12);
}

// The edges of a prescribed mesh must be open to selectors; a rigid body must keep nothing but its outline.
TEST(import, prescribed_mesh_selectors_and_rigid) {
  GeometryOptions options;
  options.files = {scene_file("two_blocks_dual/two_blocks.msh")};
  options.bodies = {body("left"), body("right")};
  options.bodies[1].rigid = true;
  options.boundaries = {boundary("face", "left"), boundary("left_left", "right")};
  options.boundaries[0].nearest_mm = Vec2(0, -0.5);
  options.boundaries[1].box_mm = {-0.01, -1.1, 0.01, 0.1};
  const Geometry geometry = build(options);
  EXPECT_EQ(geometry.bodies[0].boundaries.at("face"), geometry.bodies[0].boundaries.at("left_right"));
  EXPECT_EQ(geometry.bodies[1].cell_count(), 0);
  EXPECT_EQ(geometry.bodies[1].node_count(), 12);
  EXPECT_NEAR(mesh::length(geometry.bodies[1].X, geometry.bodies[1].boundaries.at("left_left")), 1.0, 1e-15);
}

}  // namespace
