#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/arc.hpp"
#include "support.hpp"
#include "support/three_arcs.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

constexpr double radius = 10.0;

/// A bore in a ring, its circle begun at an angle, or drawn as three arcs, two of which meet there.
GeometryOptions bore(double seam_deg, bool arcs = false) {
  const std::string from = std::to_string(seam_deg * std::numbers::pi / 180.0);
  const auto circle = [](int number, double r, const std::string& begin, const std::string& end) {
    return "Circle(" + std::to_string(number) + ") = {0, 0, 0, " + std::to_string(r) + ", " + begin + ", " + end +
           "};\n";
  };
  std::string text = "SetFactory(\"OpenCASCADE\");\n" + circle(1, 15.0, "0", "2*Pi");
  text += arcs ? support::three_arcs(seam_deg) : circle(2, radius, from, from + " + 2*Pi");
  text += std::string("Curve Loop(1) = {1};\nCurve Loop(2) = {2") + (arcs ? ", 8, 9" : "") +
          "};\nPlane Surface(1) = {1, 2};\nPhysical Surface(\"bush\") = {1};\n" +
          (arcs ? "Physical Curve(\"bore\") = {2, 8, 9};\n" : "Physical Curve(\"bore\") = {2};\n");
  GeometryOptions options;
  options.files = {
      temporary_file("bore_" + std::to_string(static_cast<int>(seam_deg)) + (arcs ? "_arcs.geo" : ".geo"), text)};
  options.bodies = {body("bush")};
  options.bodies[0].mesh.far_size_mm = 2.0;
  options.fine_zones = {{{"bush"}, {0.0, -radius}, 6.0, 2.0, 0.25, 0.0}};
  return options;
}

Points bore_nodes(const mesh::Mesh& mesh) {
  Points nodes;
  for (int node : mesh::nodes_of(mesh.boundaries.at("bore"))) nodes.push_back(mesh.X[node]);
  return nodes;
}

double distance(const Points& all, const Vec2& p) {
  double least = INFINITY;
  for (const Vec2& x : all) least = std::min(least, (x - p).norm());
  return least;
}

}  // namespace

// Where a file begins a bore must change no node of it, nor where its arc length begins: opposite to the fine zone.
TEST(rings, the_seam_is_an_accident_of_the_file) {
  const auto first = build(bore(0.0)).bodies[0];
  const auto nodes = bore_nodes(first);
  for (const double seam : {90.0, 180.0, 225.0, 270.0, 271.0, 300.0}) {
    const auto mesh = build(bore(seam)).bodies[0];
    const auto here = bore_nodes(mesh);
    ASSERT_EQ(here.size(), nodes.size()) << seam;
    for (const Vec2& p : here) EXPECT_LT(distance(nodes, p), 1e-8) << seam;
    const auto chains = mesh::arc_chains(mesh, "bore");
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_LT((mesh.X[chains[0].nodes.front()] - Vec2(0.0, radius)).norm(), 1e-8) << seam;
    EXPECT_EQ(chains[0].nodes.front(), chains[0].nodes.back());
  }
}

// A bore drawn as three arcs that meet anywhere in its fine zone must be as fine on both sides, without slivers.
TEST(rings, a_joint_in_the_zone_leaves_no_sliver) {
  for (const double joint : {270.0, 270.1, 275.0}) {
    const auto mesh = build(bore(joint, true)).bodies[0];
    EXPECT_GT(mesh::poorest_cell(mesh).scaled_jacobian, 0.4) << joint;
    const auto chains = mesh::arc_chains(mesh, "bore");
    ASSERT_EQ(chains.size(), 1U);
    const auto& [ring, arc, along] = chains[0];
    double left = 0.0, right = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
      const Vec2 middle = 0.5 * (mesh.X[ring[i]] + mesh.X[ring[i - 1]]);
      if (middle.y() > 0.0 || std::abs(middle.x()) > 5.5) continue;
      EXPECT_NEAR(arc[i] - arc[i - 1], 0.25, 0.08) << joint << " at " << middle.x();
      (middle.x() < 0.0 ? left : right) += arc[i] - arc[i - 1];
    }
    EXPECT_NEAR(left, right, 0.6) << joint;
  }
}
