#include "output/solid/solid_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "output/picture/key_pieces.hpp"
#include "output/solid/depth_picture.hpp"
#include "output/solid/skin_edges.hpp"
#include "solid_sample.hpp"
#include "support/texts.hpp"
#include "well_formed.hpp"

using namespace reye::output;
using reye::support::holds;

namespace {

std::string picture_of(const reye::scene::SolidScene& scene) {
  return solid_picture(scene, std::vector<reye::mesh::SolidMesh>{*solid_sample::lower(), *solid_sample::upper()});
}

SpaceView from_above() {
  return space_view(Vec3::UnitZ(), Vec3::UnitY(), {{0.0, 0.0}, {200.0, 100.0}}, {{0.0, 0.0, 0.0}, {2.0, 1.0, 0.0}});
}

Points3 square(double low, double high, double z) {
  return {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}};
}

}  // namespace

// The picture is well-formed, names bodies with their materials, both sides of the contact, what acts with its value
// and history, and fine zones; a text of the user is escaped.
TEST(SolidPicture, NamesEverything) {
  const std::string svg = picture_of(solid_sample::scene());
  EXPECT_TRUE(sample::well_formed(svg));
  for (const char* shown :
       {"Block &lt;on&gt; block", ">pin &amp; co</text>", ">flat</text>",
        "body flat: steel, E 210000 MPa, nu 0.3, 12 nodes, 2 elements",
        "contact pad: secondary side z1 (left), primary side upper_z0; friction 0.5",
        "support shaker on face upper_z1: x 0.02 mm × slide, z -100 N × press; as one rigid face",
        "load oil on face upper_x0: pressure 3 MPa", "fine zone of contact pad: elements of 0.1 mm",
        "contact pad, secondary side, flat alone", "slide, from -1 to 1", " mm</text>", "stroke-dasharray"})
    EXPECT_TRUE(holds(svg, shown)) << shown;
  for (const char* letter : {">A</text>", ">B</text>", ">C</text>"}) EXPECT_TRUE(holds(svg, letter)) << letter;
  for (const char* never : {"nan", "inf"}) EXPECT_FALSE(holds(svg, never)) << never;
}

// Words of the key that are too long for the picture fill further lines, all of them, each inside it.
TEST(KeyPieces, LongWordsAreBrokenIntoLines) {
  std::string words;
  for (int k = 0; k < 60; ++k) words += (k ? " sliding" : "sliding") + std::to_string(k);
  double y = 10.0;
  const std::string svg = key_lines(74.0, y, words, 19.0);
  EXPECT_EQ(y, 10.0 + 19.0 * static_cast<double>(std::count(svg.begin(), svg.end(), '\n')));
  EXPECT_GT(y, 2 * 19.0);
  std::string again;
  std::istringstream lines(svg);
  for (std::string line; std::getline(lines, line);) {
    const auto begin = line.find('>') + 1, end = line.find("</text>");
    EXPECT_LT(end - begin, 165U);
    again += (again.empty() ? "" : " ") + line.substr(begin, end - begin);
  }
  EXPECT_EQ(again, words);
}

// Supports and loads on bodies or faces that no mesh has are listed in the key and drawn nowhere.
TEST(SolidPicture, UnknownFaces) {
  auto scene = solid_sample::scene();
  scene.supports[0].face = "nowhere";
  scene.loads[0].face.clear();
  scene.loads[0].body = "nobody";
  scene.contacts[0].secondary = "none";
  const std::string svg = picture_of(scene);
  EXPECT_TRUE(sample::well_formed(svg));
  EXPECT_TRUE(holds(svg, "support ground on face nowhere"));
}

// A rigid body, which has no cells, is drawn and said to be rigid.
TEST(SolidPicture, RigidBody) {
  auto scene = solid_sample::scene();
  scene.geometry.bodies[1].rigid = true;
  auto rigid = *solid_sample::upper();
  rigid.cells.clear();
  const std::string svg = solid_picture(scene, std::vector<reye::mesh::SolidMesh>{*solid_sample::lower(), rigid});
  EXPECT_TRUE(holds(svg, "body pin &amp; co: rigid, 27 nodes, 12 facets"));
}

// Of two squares over one another the nearer is seen, whatever the order in which they were added.
TEST(DepthPicture, NearerCoversFarther) {
  for (const bool near_first : {true, false}) {
    DepthPicture picture(from_above());
    for (const bool near : {near_first, !near_first})
      picture.add(near ? square(0.25, 0.75, 1.0) : square(0.0, 1.0, 0.0), near ? "#111111" : "#222222");
    EXPECT_TRUE(picture.sees({0.5, 0.5, 1.0}));
    EXPECT_FALSE(picture.sees({0.5, 0.5, 0.0}));
    EXPECT_TRUE(picture.sees({0.1, 0.1, 0.0}));
    EXPECT_FALSE(picture.sees({5.0, 0.5, 0.0}));  // beyond the field
    const std::string svg = picture.svg();
    EXPECT_TRUE(holds(svg, "#111111") && holds(svg, "#222222"));
  }
}

// A square is one closed path of four corners, without the steps of the raster.
TEST(DepthPicture, StraightBorders) {
  DepthPicture picture(from_above());
  picture.add({{0.5, 0.1, 0.0}, {1.2, 0.5, 0.0}, {0.8, 0.9, 0.0}, {0.1, 0.6, 0.0}}, "#333333");
  const std::string svg = picture.svg();
  const auto count = [&](char c) {
    return std::count(svg.begin(), svg.begin() + static_cast<long>(svg.find("fill")), c);
  };
  EXPECT_EQ(count('M'), 1);
  EXPECT_EQ(count('Z'), 1);
  EXPECT_GE(count('L'), 3);
  EXPECT_LE(count('L'), 8);
}

// The view keeps lengths across it and shows what it was asked for inside the field.
TEST(SpaceView, ShowsAllPoints) {
  const Points3 points{{1.0, 2.0, 3.0}, {-4.0, 0.5, 2.0}, {0.0, 0.0, 9.0}};
  const SpaceView view = space_view({0.6, -1.0, 0.5}, Vec3::UnitZ(), {{10.0, 20.0}, {310.0, 220.0}}, points);
  for (const auto& x : points) EXPECT_TRUE(view.field.holds(view.pixel(x)));
  EXPECT_NEAR((view.pixel(points[0] + view.right) - view.pixel(points[0])).x(), view.pixels_per_mm, 1e-12);
  EXPECT_NEAR((view.pixel(points[0] + view.toward) - view.pixel(points[0])).norm(), 0.0, 1e-9);
  EXPECT_LT(view.pixel(points[2]).y(), view.pixel(points[0]).y());  // z upwards
}

// The edges of a block of 2 x 1 x 1 elements are features along its twelve edges alone.
TEST(SkinEdges, FeaturesOfABlock) {
  const auto edges = skin_edges(*solid_sample::lower());
  EXPECT_EQ(edges.size(), 20u);  // twelve corner-to-corner lines, four of them halved, and the four of the middle
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.feature; }), 16);
}
