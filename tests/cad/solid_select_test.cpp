#include <cmath>
#include <numbers>

#include "cad/solid/select_solid.hpp"
#include "solid_support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;
using base::Vec3;

SolidGeometryOptions assembly_of(std::vector<SolidBodyOptions> bodies) {
  return solid_options({solid_scene("assembly_solid/assembly.step")}, std::move(bodies));
}

// A point inside must find its solid, however near to a curved face it lies, and a label its product.
TEST(solid_select, bodies) {
  SolidGeometryOptions options = assembly_of({solid_body("a"), solid_body("b"), solid_body("plate")});
  options.bodies[0].at = Vec3(0, 0, 0.001);   // in the block's round foot
  options.bodies[1].at = Vec3(0, 0, -6.001);  // in the clamp's
  const SolidGeometry geometry = build_solids(options);
  EXPECT_NEAR(geometry.facts[0].box_mm[5], 10.0, 1e-6);
  EXPECT_NEAR(geometry.facts[1].box_mm[2], -20.0, 1e-6);
  EXPECT_NEAR(geometry.facts[1].box_mm[5], -6.0, 1e-6);
  options.bodies[0] = solid_body("x");
  options.bodies[0].label = "pin_block";
  EXPECT_NEAR(build_solids(options).facts[0].volume_mm3, geometry.facts[0].volume_mm3, 1e-9);
}

// The only solid of the files needs no name and no point.
TEST(solid_select, only_solid) {
  const SolidGeometry geometry =
      build_solids(solid_options({solid_scene("ball_on_flat/ball.step")}, {solid_body("punch")}));
  EXPECT_EQ(geometry.facts[0].name, "punch");
}

// Boxes, types and nearest points must pick the faces of the CAD, alone and together.
TEST(solid_select, faces) {
  SolidGeometryOptions options = assembly_of({solid_body("pin_block"), solid_body("clamp")});
  options.faces = {face_of("foot", "pin_block"), face_of("top", "pin_block"), face_of("sides", "pin_block"),
                   face_of("all", "pin_block"),  face_of("tip", "clamp"),     face_of("round", "clamp")};
  options.faces[0].type = "cylinder";
  options.faces[1].box_mm = std::array{-4.1, -6.1, 9.9, 4.1, 6.1, 10.1};
  options.faces[2].type = "plane";
  options.faces[2].box_mm = std::array{-4.1, -6.1, -0.1, 4.1, 6.1, 10.1};
  options.faces[4].type = "sphere";
  options.faces[5].nearest_mm = Vec3(5, 0, -6.6);  // beside the edge to the sphere
  const SolidGeometry geometry = build_solids(options);
  const double angle = std::asin(0.2), foot = 2.0 * angle * 20.0 * 12.0;
  const auto& block = geometry.facts[0].face_area_mm2;
  EXPECT_NEAR(block.at("foot"), foot, 1e-6);
  EXPECT_NEAR(block.at("top"), 96.0, 1e-6);
  EXPECT_EQ(geometry.bodies[0].faces.at("all").size(), geometry.bodies[0].skin.size());
  EXPECT_NEAR(block.at("sides") + block.at("foot"), block.at("all"), 1e-6);
  EXPECT_NEAR(geometry.facts[1].face_area_mm2.at("tip"), 2.0 * solid_pi * 30.0 * (30.0 - std::sqrt(875.0)), 1e-6);
  EXPECT_NEAR(geometry.facts[1].face_area_mm2.at("round"), 10.0 * solid_pi * (14.0 - (30.0 - std::sqrt(875.0))), 1e-6);
  EXPECT_NEAR(meshed_area(geometry.bodies[0], "foot"), foot, 1e-3);
}

// The face on which a point lies must be the nearest to it even where its triangles cut the corner.
TEST(solid_select, nearest_by_the_cad) {
  SolidGeometryOptions options = solid_options({solid_scene("ball_on_flat/ball.step")}, {solid_body("ball")});
  options.faces = {face_of("contact", "ball"), face_of("sx", "ball")};
  const double angle = 0.3;
  options.faces[0].nearest_mm =
      Vec3(0.1, 50.0 * std::sin(angle), 50.0 - std::sqrt(2500.0 - 0.01 - std::pow(50.0 * std::sin(angle), 2)));
  options.faces[1].nearest_mm = Vec3(0.0, 20.0, 20.0);
  const SolidGeometry geometry = build_solids(options);
  EXPECT_NEAR(geometry.facts[0].face_area_mm2.at("contact"), 1250.0 * solid_pi, 1e-3);
  EXPECT_NEAR(geometry.facts[0].face_area_mm2.at("sx"), 625.0 * solid_pi, 1e-3);
}

// Names of physical surfaces must stay, and one face may have two names.
TEST(solid_select, physical_names_and_second_names) {
  SolidGeometryOptions options = solid_options({solid_scene("pin_in_bush/pin_in_bush.geo")}, {solid_body("bush")});
  options.faces = {face_of("bore", "bush"), face_of("bush_sx", "bush")};
  options.faces[0].nearest_mm = Vec3(10, 0, 5);
  const SolidGeometry geometry = build_solids(options);
  const mesh::SolidMesh& bush = geometry.bodies[0];
  EXPECT_EQ(bush.faces.at("bore"), bush.faces.at("bush_contact"));
  EXPECT_NEAR(geometry.facts[0].face_area_mm2.at("bush_sx"), 120.0, 1e-6);
}

// A nearest face that is a part of a smooth one must be reported, and box and type must take all of its parts.
TEST(solid_select, parts_of_a_smooth_face) {
  SolidGeometryOptions options = solid_options({solid_data("split_bore.geo")}, {solid_body("bush")});
  options.faces = {face_of("bore", "bush"), face_of("both", "bush"), face_of("end", "bush")};
  options.faces[0].nearest_mm = Vec3(7, 7, 5);
  options.faces[1].type = "cylinder";
  options.faces[1].box_mm = std::array{-0.1, -10.1, -0.1, 10.1, 10.1, 10.1};
  options.faces[2].nearest_mm = Vec3(10, 10, 10);
  const SolidGeometry geometry = build_solids(options);
  EXPECT_NEAR(geometry.facts[0].face_area_mm2.at("bore"), 50.0 * solid_pi, 1e-6);
  EXPECT_NEAR(geometry.facts[0].face_area_mm2.at("both"), 100.0 * solid_pi, 1e-6);
  ASSERT_EQ(geometry.warnings.size(), 1u);
  EXPECT_NE(geometry.warnings[0].find("face 'bore' is a part of a smooth cylinder"), std::string::npos);
}

// Elements too large for a thin wall must be reported, and a size that is hardly meant.
TEST(solid_select, warnings) {
  SolidGeometryOptions options =
      solid_options({solid_data("thin_tube.geo")}, {solid_body("tube"), solid_body("far_too_large")});
  const SolidGeometry geometry = build_solids(options);
  ASSERT_EQ(geometry.warnings.size(), 2u);
  EXPECT_NE(geometry.warnings[0].find(": its elements are too large"), std::string::npos) << geometry.warnings[0];
  EXPECT_NE(geometry.warnings[1].find("body 'far_too_large' is 346410 mm large"), std::string::npos);
}

// Each selector that matches nothing or several things must be an issue of its own, all of them at once.
TEST(solid_select, refusals) {
  SolidGeometryOptions options = assembly_of(
      {solid_body("nowhere"), solid_body("unknown"), solid_body("plate"), solid_body("again"), solid_body("clamp")});
  options.bodies[0].at = Vec3(0, 0, 50);
  options.bodies[1].label = "punch";
  options.bodies[3].at = Vec3(10, 0, -3);
  options.faces = {face_of("a", "plate"), face_of("b", "plate"), face_of("c", "clamp"), face_of("d", "nobody")};
  options.faces[0].box_mm = std::array{0.0, 0.0, 0.0, 1.0, 1.0, 1.0};
  options.faces[1].type = "sphere";
  options.faces[2].nearest_mm = Vec3(0, 0, -1000);
  options.faces[2].type = "plane";
  const std::string issues = solid_issues(options);
  for (const char* expected :
       {"body.nowhere.at = [0, 0, 50]: the point lies in no solid; there are: 'plate' in box [-20, -15, -6, 20, 15, 0]",
        "body.unknown.name = \"punch\": is the name of no solid", "body.again: selects the same solid as body 'plate'",
        "face.a.box_mm = [0, 0, 0, 1, 1, 1]: matches no face of body 'plate', which has: plane in box",
        "face.b.type = \"sphere\": matches no face", "face.d.body = \"nobody\": there is no body of that name"})
    EXPECT_NE(issues.find(expected), std::string::npos) << expected << "\nin\n" << issues;
  EXPECT_EQ(issues.find("face.c"), std::string::npos) << "the clamp has one plane";
}

// A point that is equally near to two faces must not decide.
TEST(solid_select, nearest_to_two) {
  SolidGeometryOptions options = assembly_of({solid_body("plate")});
  options.faces = {face_of("edge", "plate")};
  options.faces[0].nearest_mm = Vec3(25, 0, 5);
  EXPECT_NE(solid_issues(options).find("face.edge.nearest_mm = [25, 0, 5]: is equally near to: plane"),
            std::string::npos);
}

// Solids that share a face, surfaces without solid, cells of other kinds and edges of four facets must be refused with
// their file or body.
TEST(solid_select, what_is_no_solid) {
  const auto refusal = [](const std::string& file, const char* body) {
    return solid_issues(solid_options({file}, {solid_body(body)}));
  };
  EXPECT_NE(solid_issues(solid_options({solid_data("joined.geo")}, {solid_body("lower"), solid_body("upper")}))
                .find("body.upper: shares a face with body 'lower': plane in box [0, 0, 0, 1, 1, 0]"),
            std::string::npos);
  EXPECT_NE(refusal(REYE_SOURCE_DIR "/tests/cad/data/plate.step", "a").find("holds faces but no solid"),
            std::string::npos);
  EXPECT_NE(refusal(solid_data("prism.msh"), "a").find("all tetrahedra of 4 or 10 nodes or all hexahedra of 8"),
            std::string::npos);
  EXPECT_NE(refusal(solid_data("touching_at_edge.msh"), "a").find("4 of its facets meet at one edge round [1, 1, 0.5]"),
            std::string::npos);
  EXPECT_NE(refusal(solid_data("recombined.geo"), "a").find("asks for quadrilaterals"), std::string::npos);
  EXPECT_NE(refusal("/nowhere.step", "a").find("there is no such file"), std::string::npos);
  EXPECT_NE(solid_issues(solid_options({}, {})).find("geometry = []: names no file"), std::string::npos);
}

// A file that crashes gmsh or OpenCASCADE must end in an issue, and the sound files beside it must still be read.
TEST(solid_select, crash_of_the_importer) {
  const std::string issues = solid_issues(
      solid_options({REYE_SOURCE_DIR "/tests/cad/data/broken/line_32.step", solid_scene("ball_on_flat/ball.step"),
                     REYE_SOURCE_DIR "/tests/cad/data/broken/tag_of_none.msh"},
                    {solid_body("ball")}));
  EXPECT_NE(issues.find("line_32.step\": the program that reads it"), std::string::npos) << issues;
  EXPECT_NE(issues.find("tag_of_none.msh\": "), std::string::npos) << issues;
  EXPECT_EQ(issues.find("ball.step"), std::string::npos) << issues;
}

}  // namespace
