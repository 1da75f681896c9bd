#include "cad/part/half.hpp"

#include <algorithm>
#include <numbers>

#include "mesh/outline.hpp"
#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

/// A stepped pin with a ball end of radius 4 and a spherical void, drawn whole or as its half by hand.
std::string pin(bool whole) {
  const std::string head =
      "Point(1) = {0, 0, 0};\nPoint(2) = {4, 4, 0};\nPoint(3) = {4, 8, 0};\nPoint(4) = {2, 8, 0};\nPoint(5) = {2, 10, "
      "0};\n"
      "Point(6) = {0, 10, 0};\nPoint(9) = {0, 4, 0};\nPoint(10) = {0, 5, 0};\nPoint(11) = {1, 6, 0};\nPoint(12) = {0, "
      "7, 0};\n"
      "Point(13) = {0, 6, 0};\nCircle(1) = {1, 9, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 5};\n"
      "Circle(20) = {10, 13, 11};\nCircle(21) = {11, 13, 12};\n";
  if (!whole)
    return head +
           "Line(5) = {5, 6};\nLine(6) = {6, 12};\nLine(7) = {10, 1};\nCurve Loop(1) = {1, 2, 3, 4, 5, 6, -21, -20, "
           "7};\n"
           "Plane Surface(1) = {1};\nPhysical Surface(\"pin\") = {1};\nPhysical Curve(\"ball\") = {1};\nPhysical "
           "Curve(\"top\") = {5};\n";
  return head +
         "Point(22) = {-4, 4, 0};\nPoint(23) = {-4, 8, 0};\nPoint(24) = {-2, 8, 0};\nPoint(25) = {-2, 10, "
         "0};\nPoint(31) = {-1, 6, 0};\n"
         "Line(5) = {5, 25};\nLine(14) = {25, 24};\nLine(13) = {24, 23};\nLine(12) = {23, 22};\nCircle(11) = {22, 9, "
         "1};\n"
         "Circle(30) = {12, 13, 31};\nCircle(31) = {31, 13, 10};\nCurve Loop(1) = {1, 2, 3, 4, 5, 14, 13, 12, "
         "11};\nCurve Loop(2) = {20, 21, 30, 31};\n"
         "Plane Surface(1) = {1, 2};\nPhysical Surface(\"pin\") = {1};\nPhysical Curve(\"ball\") = {1, 11};\nPhysical "
         "Curve(\"top\") = {5};\n"
         "Physical Curve(\"left\") = {12};\nPhysical Curve(\"shoulders\") = {3, 13};\n";
}

GeometryOptions of_script(const std::string& name, const std::string& script) {
  GeometryOptions options;
  options.files = {temporary_file(name, script)};
  options.axisymmetric = true;
  options.bodies = {body("pin")};
  options.bodies[0].mesh.far_size_mm = 0.5;
  options.fine_zones = {{{}, {0, 0}, 1.0, 0.3, 0.1, 0.0}};
  return options;
}

/// A rectangle from x = -left to right, and what is said of it.
std::string said_of(const std::string& shapes, const std::vector<BoundaryOptions>& boundaries = {}) {
  GeometryOptions options = of_script("said.geo", "SetFactory(\"OpenCASCADE\");\n" + shapes);
  options.fine_zones.clear();
  options.boundaries = boundaries;
  return issues_of(options);
}

}  // namespace

// Of a whole section the half x >= 0 must be meshed node by node as the half that is drawn by hand, and have its
// boundaries.
TEST(half, meshes_as_the_half_by_hand) {
  const Geometry whole = build(of_script("whole.geo", pin(true))), half = build(of_script("half.geo", pin(false)));
  const mesh::Mesh &a = whole.bodies[0], &b = half.bodies[0];
  ASSERT_EQ(a.node_count(), b.node_count());
  for (int i = 0; i < a.node_count(); ++i) EXPECT_LT((a.X[i] - b.X[i]).norm(), 1e-10) << i;
  EXPECT_EQ(a.cells, b.cells);
  for (const char* name : {"ball", "top"}) EXPECT_EQ(a.boundaries.at(name), b.boundaries.at(name)) << name;
  EXPECT_TRUE(whole.facts[0].halved);
  EXPECT_FALSE(half.facts[0].halved);
  EXPECT_NEAR(whole.facts[0].area_mm2, half.facts[0].area_mm2, 1e-10);
  EXPECT_NEAR(mesh::length(a.X, a.boundaries.at("shoulders")), 2.0, 1e-12);
  EXPECT_FALSE(a.boundaries.contains("left"));
  EXPECT_EQ(whole.facts[0].cut_off, (std::set<std::string>{"left"}));
  for (const auto& X : a.X) EXPECT_GE(X.x(), 0.0);
}

// A solid of revolution, cut through its axis, must give its half whatever the format, a hollow one that of its two
// faces.
TEST(half, solids_cut_through_their_axis) {
  const std::string solid =
      "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 0, 5, 0, 3};\nCylinder(2) = {0, 6, 0, 0, 5, 0, 3};\n"
      "Cylinder(3) = {0, 6, 0, 0, 5, 0, 2};\nBooleanDifference{ Volume{2}; Delete; }{ Volume{3}; Delete; }\n"
      "Physical Volume(\"pin\") = {1};\nPhysical Volume(\"bush\") = {2};\n";
  GeometryOptions options = of_script("solids.geo", solid);
  options.fine_zones.clear();
  options.bodies.push_back(body("bush"));
  options.section = Section{{0, 0, 0}, {0, 0, 1}};
  options.boundaries = {boundary("face", "pin"), boundary("wall", "bush")};
  options.boundaries[0].nearest_mm = Vec2(0, 5);
  options.boundaries[1].nearest_mm = Vec2(2, 8);
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 15.0, 1e-6);
  EXPECT_NEAR(geometry.facts[1].area_mm2, 5.0, 1e-6);
  EXPECT_NEAR(mesh::length(geometry.bodies[0].X, geometry.bodies[0].boundaries.at("face")), 3.0, 1e-9)
      << "cut where it crosses the axis";
  EXPECT_NEAR(mesh::length(geometry.bodies[1].X, geometry.bodies[1].boundaries.at("wall")), 5.0, 1e-9);
  options.bodies[1].at = Vec2(-2.5, 8);
  EXPECT_EQ(issues_of(options).find("body.bush.at = [-2.5, 8]: the point lies in no face; there are: 'pin' in"), 0U);
  EXPECT_NE(issues_of(options).find("; an axisymmetric scene takes what lies at x >= 0: give [2.5, 8]"),
            std::string::npos);
}

// A ball drawn as one circle must be cut into one arc, wherever its file begins the circle.
TEST(half, a_ring_is_cut_into_one_arc) {
  for (const char* seam : {"0", "1", "Pi/2", "Pi"}) {
    const std::string begin(seam);
    GeometryOptions options = of_script(
        "disc.geo", "SetFactory(\"OpenCASCADE\");\nCircle(1) = {0, 0, 0, 2, " + begin + ", " + begin +
                        " + 2*Pi};\nCurve Loop(1) = {1};\nPlane Surface(1) = {1};\nPhysical Surface(\"pin\") = {1};\n");
    options.fine_zones.clear();
    const Geometry geometry = build(options);
    EXPECT_NEAR(geometry.facts[0].area_mm2, 2.0 * std::numbers::pi, 1e-9) << seam;
    ASSERT_EQ(geometry.drawings[0].part.loops.size(), 1U) << seam;
    EXPECT_EQ(geometry.drawings[0].part.loops[0].size(), 2U) << seam << ": an arc and the axis";
  }
}

// A section that is not mirror-symmetric, or lies beside the axis, must be refused with the sizes that differ.
TEST(half, a_section_that_is_none_is_refused_with_its_sizes) {
  EXPECT_EQ(said_of("Rectangle(1) = {-3, 0, 0, 7, 2};\nPhysical Surface(\"pin\") = {1};\n"),
            "body.pin: lies on both sides of the axis and is not mirror-symmetric about it: it reaches from x = -3 to "
            "4, has 6 mm^2 at x < 0 and 8 "
            "mm^2 at x > 0, and its outline at [4, 0] lies 1 mm from the mirrored other half; draw it symmetric about "
            "x = 0, or its half x >= 0 alone");
  EXPECT_EQ(said_of("Rectangle(1) = {-3, 0, 0, 2, 2};\nPhysical Surface(\"pin\") = {1};\n"),
            "body.pin: reaches x = -3; in an axisymmetric scene x is the radius and nothing lies at x < 0");
  EXPECT_EQ(said_of("Rectangle(1) = {-3, 0, 0, 6, 2};\nPhysical Surface(\"pin\") = {1};\n"), "");
}

// A boundary must not lose an edge at x < 0 in silence: its mirror image is selected, too, or the message says what to
// select.
TEST(half, boundaries_at_negative_x) {
  const std::string plate = "Rectangle(1) = {-3, 0, 0, 6, 2};\nPhysical Surface(\"pin\") = {1};\n";
  auto side = boundary("side", "pin");
  side.nearest_mm = Vec2(-3, 1);
  const std::string words =
      "boundary.side: selects the line [-3, 2] to [-3, 0] at x < 0, which is cut away, and not its mirror image: of "
      "the section "
      "of body 'pin' the half x >= 0 is taken; select the edge at x > 0, or both";
  EXPECT_EQ(said_of(plate, {side}), words);
  side.nearest_mm.reset();
  side.box_mm = {-3.1, -0.1, 3.1, 0.1};
  EXPECT_EQ(said_of(plate, {side}), "") << "crosses the axis";
  side.box_mm = {-3.1, -0.1, -2.9, 2.1};
  EXPECT_EQ(said_of(plate, {side}), words);
  side.box_mm.reset();
  EXPECT_EQ(said_of(plate, {side}), "") << "the whole outline";
  side.profile = Profile{"crown.csv", {0.0, 1.0}, {0.0, 0.0}};
  EXPECT_EQ(said_of(plate, {side}),
            "boundary.side.profile = \"crown.csv\": lies on a section of which the half x >= 0 is taken; draw that "
            "half alone, so "
            "that arc length counts on it");
}

// A fine zone at x < 0 must be refused with the place that is meant.
TEST(half, zones_at_negative_x) {
  GeometryOptions options = of_script("zone.geo", pin(true));
  options.fine_zones[0].centre_mm = {-1, 0.5};
  EXPECT_EQ(issues_of(options),
            ".centre_mm = [-1, 0.5]: lies at x < 0; an axisymmetric scene takes what lies at x >= 0: give [1, 0.5]");
}

// A plate whose hole lies on the axis must be halved from STEP, BREP and .geo alike; a mesh of it must be refused with
// the reason.
TEST(half, all_formats) {
  GeometryOptions options;
  options.axisymmetric = true;
  options.bodies = {body_at("plate", 1, 1)};
  options.boundaries = {boundary("hole", "plate"), boundary("bottom", "plate")};
  options.boundaries[0].type = "circle";
  options.boundaries[1].nearest_mm = Vec2(0, -1);
  for (const char* end : {"step", "brep", "geo"}) {
    options.files = {data(std::string("plate_on_axis.") + end)};
    const Geometry geometry = build(options);
    EXPECT_NEAR(geometry.facts[0].area_mm2, 6.0 - std::numbers::pi / 8.0, 1e-6) << end;
    const mesh::Mesh& mesh = geometry.bodies[0];
    EXPECT_NEAR(mesh::length(mesh.X, mesh.boundaries.at("bottom")), 2.0, 1e-9) << end;
    EXPECT_EQ(mesh.outline.size(), 1U) << end << ": the hole opens at the axis";
    for (int node : mesh::nodes_of(mesh.boundaries.at("hole")))
      EXPECT_NEAR((mesh.X[node] - Vec2(0, 2)).norm(), 0.5, 1e-7) << end;
  }
  options.files = {data("plate_on_axis.msh")};
  options.boundaries.clear();
  EXPECT_EQ(issues_of(options),
            "body.plate: reaches x = -2; in an axisymmetric scene x is the radius and nothing lies at x < 0; a mesh is "
            "taken as it "
            "is: mesh the half x >= 0 alone");
}
