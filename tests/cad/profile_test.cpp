#include <cmath>
#include <numbers>

#include "cad/build/height_curve.hpp"
#include "cad/build/profile.hpp"
#include "mesh/outline.hpp"
#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

/// The block's face has a profile.
GeometryOptions with_profile(Profile profile) {
  GeometryOptions options = punch_on_block();
  options.boundaries = {boundary("face", "block")};
  options.boundaries[0].nearest_mm = Vec2(0, 0);
  profile.file = "scan.csv";
  options.boundaries[0].profile = profile;
  return options;
}

std::string refusal_of_csv(const std::string& csv) {
  try {
    parse_profile(csv);
    return "";
  } catch (const base::InputError& error) {
    return error.issues().at(0).rule;
  }
}

// A file of two columns must be read whatever its line ends, blank lines and byte order mark.
TEST(profile, csv) {
  const Profile profile = parse_profile(
      "\xEF\xBB\xBF"
      "arc_length_mm,height_mm\r\n0,0\r\n 0.5 , -1e-3\r\n\r\n+2,0");
  EXPECT_EQ(profile.arc_mm, (std::vector<double>{0.0, 0.5, 2.0}));
  EXPECT_EQ(profile.height_mm, (std::vector<double>{0.0, -1e-3, 0.0}));
}

// A file that is no profile must be refused with the line at fault.
TEST(profile, bad_csv) {
  const std::string head = "arc_length_mm,height_mm\n";
  EXPECT_EQ(refusal_of_csv("s,h\n0,0\n1,0\n"), "its first line must be arc_length_mm,height_mm");
  EXPECT_EQ(refusal_of_csv(head + "0,0\n"), "needs at least two rows of numbers");
  EXPECT_EQ(refusal_of_csv(head), "needs at least two rows of numbers");
  EXPECT_EQ(refusal_of_csv(head + "0,0\n1;0\n"), "line 3: must be two numbers with a comma between them");
  EXPECT_EQ(refusal_of_csv(head + "0,0\n1,0,0\n"), "line 3: must be two numbers with a comma between them");
  EXPECT_EQ(refusal_of_csv(head + "0,0\n\n1,\n"), "line 4: must be two numbers with a comma between them");
  EXPECT_EQ(refusal_of_csv(head + "0,0\n1,nan\n"), "line 3: must be finite");
  EXPECT_EQ(refusal_of_csv(head + "0,inf\n1,0\n"), "line 2: must be finite");
  EXPECT_EQ(refusal_of_csv(head + "-1,0\n1,0\n"), "line 2: arc_length_mm must be >= 0");
  EXPECT_EQ(refusal_of_csv(head + "0,0\n1,0\n1,0\n"), "line 4: arc_length_mm must increase");
}

// Heights must pass through the points, keep between neighbouring ones, be smooth, and have the slope they say.
TEST(profile, height_curve) {
  const std::vector<double> s{0.0, 1.0, 1.5, 4.0, 4.1, 6.0}, h{0.0, 2.0, 2.0, -1.0, 3.0, 0.0};
  const HeightCurve curve(s, h);
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_DOUBLE_EQ(curve.at(s[i])[0], h[i]);
  for (std::size_t i = 0; i + 1 < s.size(); ++i)
    for (double u : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double x = s[i] + u * (s[i + 1] - s[i]), step = 1e-6;
      const auto [height, slope] = curve.at(x);
      EXPECT_GE(height, std::min(h[i], h[i + 1]) - 1e-15);
      EXPECT_LE(height, std::max(h[i], h[i + 1]) + 1e-15);
      EXPECT_NEAR(slope, (curve.at(x + step)[0] - curve.at(x - step)[0]) / (2.0 * step),
                  1e-6 * (1.0 + std::abs(slope)));
    }
  const HeightCurve line({0.0, 1.0, 3.0}, {0.0, 2.0, 6.0});
  for (double x : {0.0, 0.4, 1.0, 2.0, 3.0}) EXPECT_NEAR(line.at(x)[0], 2.0 * x, 1e-14);
}

// Nodes of a straight face must lie at the heights of the profile, zero outside of its range, with arc length from the
// end of smaller x although the body's outline runs the other way; the area must follow.
TEST(profile, on_a_straight_face) {
  const Geometry geometry = build(with_profile({"", {2.0, 2.5, 3.0, 3.5}, {0.0, -0.1, -0.05, 0.0}}));
  const HeightCurve expected({0.0, 2.0, 2.5, 3.0, 3.5, 6.0}, {0.0, 0.0, -0.1, -0.05, 0.0, 0.0});
  const mesh::Mesh& block = geometry.bodies[1];
  double area = 12.0;
  for (int i = 0; i < 100000; ++i) area += 6e-5 * expected.at(6e-5 * (i + 0.5))[0];
  EXPECT_NEAR(geometry.facts[1].area_mm2, area, 1e-7);
  double deepest = 0.0;
  for (int node : mesh::nodes_of(block.boundaries.at("face"))) {
    const Vec2 p = block.X[node];
    EXPECT_NEAR(p.y(), expected.at(p.x() + 3.0)[0], 1e-5);
    deepest = std::min(deepest, p.y());
  }
  EXPECT_LT(deepest, -0.08);
}

// A profile of zeros must change nothing but the kind of the edge.
TEST(profile, of_zeros) {
  GeometryOptions options = with_profile({"", {0.0, 6.0}, {0.0, 0.0}});
  const Geometry with = build(options);
  options.boundaries[0].profile.reset();
  const Geometry without = build(options);
  ASSERT_EQ(with.bodies[1].cells, without.bodies[1].cells);
  for (std::size_t i = 0; i < with.bodies[1].X.size(); ++i)
    EXPECT_NEAR((with.bodies[1].X[i] - without.bodies[1].X[i]).norm(), 0.0, 1e-9);
}

// A height on an arc must act along its radius: a constant one makes a circle of another radius.
TEST(profile, on_an_arc) {
  GeometryOptions options = cylinder_on_flat(mesh::CellKind::quad4, 0.8, 0.02);
  const double length = 6.0 * std::numbers::pi;
  options.boundaries[1].profile = Profile{"scan.csv", {0.0, length}, {-0.5, -0.5}};
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 0.5 * std::numbers::pi * 5.5 * 5.5, 1e-9)
      << "the top is shorter at both ends";
  const mesh::Mesh& cylinder = geometry.bodies[0];
  for (int node : mesh::nodes_of(cylinder.boundaries.at("round")))
    EXPECT_NEAR((cylinder.X[node] - Vec2(0, 6)).norm(), 5.5, 1e-9);
  EXPECT_NEAR(mesh::length(cylinder.X, cylinder.boundaries.at("top")), 11.0, 1e-9);
}

// Fine zones must work on a face with a profile: a scar with equal fine elements along it.
TEST(profile, fine_zone_in_a_scar) {
  GeometryOptions options = cylinder_on_flat(mesh::CellKind::quad4, 0.8, 0.01);
  Profile scar{"scan.csv", {}, {}};
  for (int i = -50; i <= 50; ++i) {
    scar.arc_mm.push_back(6.0 + 0.008 * i);
    scar.height_mm.push_back(-0.02 * std::pow(std::cos(0.01 * std::numbers::pi * i), 2) * (std::abs(i) < 50));
  }
  options.boundaries[2].profile = scar;
  const Geometry geometry = build(options);
  const mesh::Mesh& flat = geometry.bodies[1];
  EXPECT_GT(mesh::poorest_cell(flat).scaled_jacobian, 0.4);
  const std::vector<int> nodes = mesh::nodes_of(flat.boundaries.at("face"));
  double deepest = 0.0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Vec2 &a = flat.X[nodes[i]], &b = flat.X[nodes[i + 1]];
    if (std::max(std::abs(a.x()), std::abs(b.x())) < 0.49) {
      EXPECT_NEAR((b - a).norm(), 0.01, 5e-4);
    }
    deepest = std::min(deepest, a.y());
  }
  EXPECT_NEAR(deepest, -0.02, 1e-6);
}

// A profile that does not fit its boundary must be refused with what is wrong.
TEST(profile, refusals) {
  const auto refusal = [](Profile profile) { return issues_of(with_profile(std::move(profile))); };
  const std::string key = "boundary.face.profile = \"scan.csv\": ";
  EXPECT_EQ(refusal({"", {0, 7}, {0, 0}}), key + "reaches to arc length 7 mm; the boundary is 6 mm long");
  EXPECT_EQ(refusal({"", {1, 2}, {0.1, 0}}),
            key + "the height at arc length 1 mm, where it ends within the boundary, is 0.1 mm; it must be 0 there");
  EXPECT_EQ(refusal({"", {1, 2}, {0, 0.1}}),
            key + "the height at arc length 2 mm, where it ends within the boundary, is 0.1 mm; it must be 0 there");
  EXPECT_EQ(refusal({"", {0, 3, 6}, {0, 1e3, 0}}),
            key + "a height of 1000 mm is out of proportion to a boundary 6 mm long");
  EXPECT_EQ(refusal({"", {1, 3, 5}, {0, -3, 0}}).substr(0, key.size() + 36),
            key + "makes the outline cross itself near ");
  EXPECT_EQ(refusal({"", {0, 6}, {-2.5, -2.5}}),
            key + "the height at the end [3, 0] of the boundary takes all of the next edge, line [3, -2] to [3, 0]");
  EXPECT_NEAR(build(with_profile({"", {0, 6}, {-0.5, -0.5}})).facts[1].area_mm2, 9.0, 1e-9);
}

// A boundary that no profile can lie on must be refused: in pieces, with a corner, closed, of a mesh, taken twice.
TEST(profile, boundaries_that_cannot_have_one) {
  const Profile zero{"scan.csv", {0, 1}, {0, 0}};
  const std::string key = "boundary.face.profile = \"scan.csv\": ";
  GeometryOptions options = with_profile(zero);
  options.boundaries[0].nearest_mm.reset();
  EXPECT_EQ(issues_of(options), key + "needs a boundary with two ends; this one goes all round");
  options.boundaries[0].box_mm = {2.9, -2.1, 3.1, 0.1};
  options.boundaries.push_back(options.boundaries[0]);
  options.boundaries[1].name = "again";
  EXPECT_EQ(issues_of(options),
            "boundary.again.profile = \"scan.csv\": shares an edge with boundary 'face', which has a profile too");
  options = cylinder_on_flat(mesh::CellKind::quad4, 0.8, 0.0);
  options.boundaries[0].profile = Profile{"scan.csv", {0, 12}, {0.1, 0}};
  EXPECT_EQ(issues_of(options),
            "boundary.top.profile = \"scan.csv\": the height at the end [-6, 6] of the boundary must be 0: no straight "
            "edge continues there at a right angle");
  options = GeometryOptions{};
  options.files = {scene_file("patch/two_blocks.msh")};
  options.bodies = {body("lower")};
  options.boundaries = {boundary("lower_top", "lower")};
  options.boundaries[0].profile = zero;
  EXPECT_EQ(issues_of(options),
            "boundary.lower_top.profile = \"scan.csv\": needs the edges of a CAD file; the body "
            "brings its own mesh");
  options.files = {temporary_file("sides.geo",
                                  "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 4, 2};\n"
                                  "Physical Surface(\"plate\") = {1};\nPhysical Curve(\"sides\") = {2, 4};\n")};
  options.bodies = {body("plate")};
  options.boundaries = {boundary("sides", "plate")};
  options.boundaries[0].profile = zero;
  EXPECT_EQ(issues_of(options),
            "boundary.sides.profile = \"scan.csv\": needs one connected boundary; this one has 2 "
            "pieces");
  options.files = {data("shared_curve.geo")};
  options.bodies = {body("right")};
  options.boundaries = {boundary("corner", "right")};
  options.boundaries[0].box_mm = {1.9, -0.1, 3.1, 1.1};
  options.boundaries[0].profile = zero;
  EXPECT_EQ(issues_of(options),
            "boundary.corner.profile = \"scan.csv\": needs a smooth boundary; this one has a corner at [3, 0]");
}

// Several smooth edges must take one profile together.
TEST(profile, over_two_edges) {
  GeometryOptions options;
  options.files = {data("shared_curve.geo")};
  options.bodies = {body("right")};
  options.boundaries = {boundary("right_bottom", "right")};
  options.boundaries[0].profile = Profile{"scan.csv", {0.5, 1.0, 1.5}, {0.0, -0.1, 0.0}};
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 2.0 - 0.05, 1e-6) << "half of the box round a symmetric scar";
  EXPECT_EQ(geometry.bodies[0].boundaries.at("right_bottom").size(), 1u);
}

}  // namespace
