#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

// Files that are missing, empty, no file, of unknown format or without a face must be refused with the reason.
TEST(refusals, files) {
  EXPECT_EQ(refusal_of_file("/nowhere/x.step"), "geometry = \"/nowhere/x.step\": there is no such file");
  for (const char* name : {"empty.step", "empty.iges", "empty.brep", "empty.geo", "empty.msh"}) {
    const std::string path = temporary_file(name, "");
    EXPECT_EQ(refusal_of_file(path), "geometry = \"" + path + "\": the file is empty");
  }
  const std::string part = temporary_file("part.stl", "solid");
  EXPECT_EQ(refusal_of_file(part),
            "geometry = \"" + part +
                "\": the format must be one of .step .stp .iges .igs .brep .geo .geo_unrolled .msh .vtu");
  const std::string folder = std::filesystem::path(part).replace_filename("folder.step");
  std::filesystem::create_directories(folder);
  EXPECT_EQ(refusal_of_file(folder), "geometry = \"" + folder + "\": is not a file");
  const std::string comment = temporary_file("comment.geo", "// nothing here\n");
  EXPECT_EQ(refusal_of_file(comment), "geometry = \"" + comment + "\": holds no face");
}

// A script whose last line gmsh would read in part must be refused.
TEST(refusals, script_without_its_last_line_break) {
  const std::string text = "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};";
  EXPECT_EQ(refusal_of_file(temporary_file("one.geo", text)), "");
  EXPECT_NE(refusal_of_file(temporary_file("two.geo", text + " Physical Surface(\"a\") = {1};")).find("line break"),
            std::string::npos);
}

// Garbage in every format must be refused, never crash or pass.
TEST(refusals, garbage) {
  for (const char* name : {"garbage.step", "garbage.iges", "garbage.brep", "garbage.geo", "garbage.msh"})
    EXPECT_TRUE(refusal_of_file(temporary_file(name, "garbage(\n")).starts_with("geometry = ")) << name;
}

// A mesh of mixed cells and a solid must be refused.
TEST(refusals, wrong_content) {
  EXPECT_NE(refusal_of_file(data("mixed.msh")).find("all triangles of 3 or 6 nodes or all quadrilaterals of 4"),
            std::string::npos);
  EXPECT_NE(refusal_of_file(data("solid.step")).find("holds a solid"), std::string::npos);
}

// All faulty files must be reported at once.
TEST(refusals, several_files_at_once) {
  GeometryOptions options;
  options.files = {"/nowhere/a.step", "/nowhere/b.step"};
  try {
    build(options);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_EQ(error.issues().size(), 2u);
  }
}

// For bodies that match nothing the message must list what there is; all of them together.
TEST(refusals, bodies_that_match_nothing) {
  GeometryOptions options = punch_on_block();
  options.bodies = {body("pnuch"), body_at("base", 0, 9), body("third")};
  options.bodies[2].label = "bolck";
  const std::string there = "; there are: 'punch' in [-1, 0, 1, 2], 'block' in [-3, -2, 3, 0]";
  EXPECT_EQ(issues_of(options), "body.pnuch: has neither 'at' nor 'name', and its own name is that of no face" + there +
                                    "\nbody.base.at = [0, 9]: the point lies in no face" + there +
                                    "\nbody.third.name = \"bolck\": is the name of no face" + there);
}

// A point inside two overlapping faces, a name that two faces bear, and a face chosen twice must be refused.
TEST(refusals, bodies_that_match_two) {
  GeometryOptions options = punch_on_block();
  options.files.push_back(data("named.step"));
  options.bodies = {body("punch"), body_at("base", 0, -1)};
  EXPECT_EQ(issues_of(options),
            "body.punch: has neither 'at' nor 'name', and its own name is that of more than one face: "
            "'punch' in [-1, 0, 1, 2], 'punch' in [-1, 0, 1, 2]\n"
            "body.base.at = [0, -1]: the point lies in more than one face: "
            "'block' in [-3, -2, 3, 0], 'block' in [-3, -2, 3, 0]");
  options = punch_on_block();
  options.bodies = {body("punch"), body_at("other", 0, 1)};
  EXPECT_EQ(issues_of(options),
            "body.other.at = [0, 1]: selects the same face as body 'punch': 'punch' in [-1, 0, 1, 2]");
}

// For boundaries that match nothing the message must list the edges of their body, each selector by its own key.
TEST(refusals, boundaries_that_match_nothing) {
  GeometryOptions options = punch_on_block();
  options.boundaries = {boundary("a", "punch"), boundary("b", "punch"), boundary("c", "none")};
  options.boundaries[0].box_mm = {5, 5, 6, 6};
  options.boundaries[1].type = "circle";
  const std::string rule =
      "matches no edge of body 'punch', which has: line [-1, 0] to [1, 0], line [1, 0] to [1, 2], "
      "line [1, 2] to [-1, 2], line [-1, 2] to [-1, 0]";
  EXPECT_EQ(issues_of(options),
            "boundary.a.box_mm = [5, 5, 6, 6]: " + rule + "\nboundary.b.type = \"circle\": " + rule +
                "\nboundary.c.body = \"none\": there is no body of that name; there are: punch, block");
}

// The nearest edge must be one; a point as near to two edges must be refused.
TEST(refusals, nearest_edge_is_one) {
  GeometryOptions options = punch_on_block();
  options.boundaries = {boundary("a", "punch")};
  options.boundaries[0].nearest_mm = Vec2(3, 3);
  EXPECT_EQ(issues_of(options),
            "boundary.a.nearest_mm = [3, 3]: is equally near to: line [1, 0] to [1, 2], line [1, 2] to [-1, 2]");
}

// In an axisymmetric scene anything at negative radius must be refused, round-off must not.
TEST(refusals, negative_radius) {
  GeometryOptions options;
  options.axisymmetric = true;
  options.files = {temporary_file("left.geo", "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {-3, 0, 0, 2, 1};\n")};
  options.bodies = {body_at("disc", -2, 0.5)};
  EXPECT_EQ(issues_of(options),
            "body.disc: reaches x = -3; in an axisymmetric scene x is the radius and nothing lies at x < 0");
  options.files = {temporary_file("axis.geo", "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {-1e-10, 0, 0, 1, 1};\n")};
  options.bodies = {body_at("disc", 0.5, 0.5)};
  EXPECT_EQ(mesh::bounding_box(build(options).bodies[0].X)[0], 0.0);
}

// A mesh of millions of nodes must be refused before it is made.
TEST(refusals, enormous_mesh) {
  GeometryOptions options = punch_on_block();
  options.fine_zones = {{{"punch"}, {0, 0}, 0.5, 0.5, 1e-5, 0.0}};
  EXPECT_NE(issues_of(options).find("body.punch: would need about"), std::string::npos);
}

}  // namespace
