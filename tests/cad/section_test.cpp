#include <numbers>

#include "mesh/outline.hpp"
#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

constexpr double block_area = 72.0 - std::numbers::pi, pad_area = 18.0 * std::numbers::pi;

/// The half cylinder on the block with a hole, cut by a plane.
GeometryOptions cut(const Vec3& point, const Vec3& normal) {
  GeometryOptions options;
  options.files = {data("two_solids.step")};
  options.section = Section{point, normal};
  options.bodies = {body("pad"), body("block")};
  return options;
}

// Solids must be found in the section by their STEP product names, with exact areas, whatever the normal's length
// and sign; at a plane face of the solids too.
TEST(section, areas_and_names) {
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0, 0, -5), Vec3(0, 0, 1e-200)})
    for (const double z : {5.0, 0.0, 8.0}) {
      const Geometry geometry = build(cut({1, 2, z}, normal));
      EXPECT_NEAR(geometry.facts[0].area_mm2, pad_area, 1e-9) << z;
      EXPECT_NEAR(geometry.facts[1].area_mm2, block_area, 1e-9) << z;
      EXPECT_NEAR(geometry.facts[0].box_mm[3], 6.0, 1e-9) << "x and y stay";
    }
}

// Circles must remain circles, so that selectors and nodes find them.
TEST(section, circles_remain) {
  GeometryOptions options = cut({0, 0, 5}, {0, 0, 1});
  options.boundaries = {boundary("round", "pad"), boundary("hole", "block")};
  for (BoundaryOptions& each : options.boundaries) each.type = "circle";
  const Geometry geometry = build(options);
  for (int node : mesh::nodes_of(geometry.bodies[0].boundaries.at("round")))
    EXPECT_NEAR((geometry.bodies[0].X[node] - Vec2(0, 6)).norm(), 6.0, 1e-9);
  for (int node : mesh::nodes_of(geometry.bodies[1].boundaries.at("hole")))
    EXPECT_NEAR((geometry.bodies[1].X[node] - Vec2(3, -3)).norm(), 1.0, 1e-9);
  EXPECT_EQ(geometry.bodies[1].outline.size(), 2u);
}

// An oblique section must have the areas over the cosine, laid into x-y with its own lengths.
TEST(section, oblique) {
  const double angle = std::numbers::pi / 6.0;
  const Geometry geometry = build(cut({0, 0, 4}, {0, -std::sin(angle), std::cos(angle)}));
  EXPECT_NEAR(geometry.facts[0].area_mm2, pad_area / std::cos(angle), 1e-6) << "an ellipse";
  EXPECT_NEAR(geometry.facts[1].area_mm2, block_area / std::cos(angle), 1e-6);
  const auto box = geometry.facts[0].box_mm;
  EXPECT_NEAR(box[2] - box[0], 12.0, 1e-9);
  EXPECT_NEAR(box[3] - box[1], 6.0 / std::cos(angle), 1e-9);
}

// A plane along the hole must give two faces of the block, distinguished by points; the pad that it misses gives none.
TEST(section, several_faces_of_one_solid) {
  GeometryOptions options = cut({0, -3, 0}, {0, 1, 0});
  options.bodies = {body_at("left", 0, 5), body_at("right", 5, 5)};
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 80.0, 1e-9);
  EXPECT_NEAR(geometry.facts[1].area_mm2, 20.0, 1e-9);
  options.bodies = {body("block")};
  EXPECT_EQ(issues_of(options),
            "body.block: has neither 'at' nor 'name', and its own name is that of more than one face: "
            "'block' in [4, 0, 6, 10], 'block' in [-6, 0, 2, 10]");
}

// Plane faces must pass a section unchanged, alone and beside solids; physical volumes must name what is cut from them.
TEST(section, beside_faces) {
  GeometryOptions options = cut({0, 0, 5}, {0, 0, 1});
  options.files.push_back(data("named.step"));
  options.bodies = {body("pad"), body("punch")};
  EXPECT_NEAR(build(options).facts[1].area_mm2, 4.0, 1e-12);
  options.files = {data("named.step")};
  options.bodies = {body("punch")};
  EXPECT_NEAR(build(options).facts[0].area_mm2, 4.0, 1e-12);
  options.files = {temporary_file("both.geo",
                                  "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 2, 2, 2};\n"
                                  "Rectangle(20) = {5, 0, 0, 1, 1};\n"
                                  "Physical Volume(\"cube\") = {1};\nPhysical Surface(\"sheet\") = {20};\n")};
  options.section->point_mm.z() = 1.0;
  options.bodies = {body("cube"), body("sheet")};
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 4.0, 1e-12);
  EXPECT_NEAR(geometry.facts[1].area_mm2, 1.0, 1e-12);
}

// A section that misses every solid must say where they lie; faces across it and solids that cannot be cut must be
// refused.
TEST(section, refusals) {
  EXPECT_EQ(
      issues_of(cut({0, 0, 20}, {0, 0, 2})),
      "section.point_mm = [0, 0, 20]: the plane, at 20 mm along its normal, misses every solid of two_solids.step: "
      "'block' from 0 to 10, 'pad' from 0 to 8");
  EXPECT_EQ(issues_of(cut({-20, 0, 0}, {1, 1, 0})),
            "section.point_mm = [-20, 0, 0]: the plane, at -14.1421 mm along its normal, misses every solid of "
            "two_solids.step: 'block' from -8.48528 to 4.24264, 'pad' from -1.75736 to 8.48528");
  GeometryOptions options = cut({0, -3, 0}, {0, 1, 0});
  options.files.push_back(data("named.step"));
  EXPECT_EQ(issues_of(options), "geometry = \"" + data("named.step") +
                                    "\": face 'punch': lies in a plane that is not parallel to the section\n"
                                    "geometry = \"" +
                                    data("named.step") +
                                    "\": face 'block': lies in a plane that is not parallel to the section");
  const std::string own =
      temporary_file("own.geo",
                     "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nLine(1) = {1, 2};\n"
                     "s[] = Extrude {0, 1, 0} { Curve{1}; };\nExtrude {0, 0, 1} { Surface{s[1]}; }\n");
  options.files = {own};
  EXPECT_EQ(issues_of(options), "geometry = \"" + own +
                                    "\": holds a solid of gmsh's own kernel; only those of "
                                    "SetFactory(\"OpenCASCADE\") can be cut");
  options = cut({0, 0, 5}, {0, 0, 1});
  options.section.reset();
  EXPECT_EQ(issues_of(options), "geometry = \"" + data("two_solids.step") +
                                    "\": holds a solid; bodies are planar faces: cut it by section = { point_mm = "
                                    "[...], normal = [...] }");
}

}  // namespace
