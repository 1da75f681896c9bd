#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "mesh/outline.hpp"
#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;
using mesh::CellKind;

/// Smallest and largest edge of a boundary within |x| <= half_width, and the largest ratio of neighbours anywhere.
struct Spacing {
  double smallest = 1e9, largest = 0.0, ratio = 1.0;
};

Spacing spacing(const mesh::Mesh& mesh, const std::string& boundary, double half_width) {
  Spacing result;
  for (const mesh::Chain& chain : mesh.boundaries.at(boundary)) {
    double last = 0.0;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Vec2 &a = mesh.X[chain[i]], &b = mesh.X[chain[i + 1]];
      const double length = (b - a).norm();
      if (std::max(std::abs(a.x()), std::abs(b.x())) < half_width * (1 + 1e-9)) {
        result.smallest = std::min(result.smallest, length);
        result.largest = std::max(result.largest, length);
      }
      if (last > 0.0) result.ratio = std::max({result.ratio, length / last, last / length});
      last = length;
    }
  }
  return result;
}

class Kinds : public testing::TestWithParam<CellKind> {};
INSTANTIATE_TEST_SUITE_P(meshing, Kinds, testing::Values(CellKind::tri3, CellKind::quad4));

// Cells must be of the kind asked for and well shaped, and in the fine zone equally spaced within 20 % of the size.
TEST_P(Kinds, fine_zone_is_equally_spaced) {
  const Geometry geometry = build(cylinder_on_flat(GetParam(), 0.8, 0.01));
  for (const mesh::Mesh& mesh : geometry.bodies) {
    EXPECT_EQ(mesh.kind, GetParam());
    EXPECT_GT(mesh::poorest_cell(mesh).scaled_jacobian, 0.4);
    for (const mesh::Cell& cell : mesh.cells) EXPECT_EQ(cell[3] >= 0, GetParam() == CellKind::quad4);
  }
  for (const auto& [b, name] : {std::pair{0, "round"}, std::pair{1, "face"}}) {
    const Spacing s = spacing(geometry.bodies[b], name, 0.5);
    EXPECT_NEAR(s.smallest, 0.01, 0.0005);
    EXPECT_LT(s.largest / s.smallest, 1.0001);
    EXPECT_LT(s.ratio, 1.5) << "growth 1.3";
  }
}

// A layer far thinner than its fine zone is deep must be meshed by itself, and its outline stay where it is drawn.
TEST_P(Kinds, layer_thinner_than_its_zone) {
  GeometryOptions options;
  options.files = {temporary_file("layer.geo", "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {-6, 0, 0, 12, 0.02};\n")};
  options.bodies = {body_at("layer", 0, 0.01)};
  options.bodies[0].mesh = {GetParam(), 0.1, 1.3};
  options.fine_zones = {{{"layer"}, {0, 0}, 1.0, 0.2, 0.05, 0.0}};
  options.boundaries = {boundary("back", "layer")};
  options.boundaries[0].nearest_mm = Vec2(0, 0);
  const mesh::Mesh layer = build(options).bodies[0];
  EXPECT_NEAR(mesh::area(layer), 12 * 0.02, 1e-12);
  EXPECT_GT(mesh::poorest_cell(layer).scaled_jacobian, 0.1);
}

// Symmetric bodies must have a node at the centre of the zone and, on the contact boundary, mirrored nodes.
TEST_P(Kinds, contact_nodes_are_symmetric) {
  const Geometry geometry = build(cylinder_on_flat(GetParam(), 0.8, 0.01));
  const mesh::Mesh& flat = geometry.bodies[1];
  std::vector<double> x;
  for (int node : mesh::nodes_of(flat.boundaries.at("face"))) x.push_back(flat.X[node].x());
  std::sort(x.begin(), x.end());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], -x[x.size() - 1 - i], 1e-9);
  EXPECT_EQ(x.size() % 2, 1u);
}

// Below the contact the cells must be rows of equal elements to the zone's depth.
TEST(meshing, fine_zone_has_rows) {
  const Geometry geometry = build(cylinder_on_flat(CellKind::quad4, 0.8, 0.01));
  const mesh::Mesh& flat = geometry.bodies[1];
  int rows = 0;
  for (const mesh::Cell& cell : flat.cells) {
    const auto box = mesh::bounding_box({flat.X[cell[0]], flat.X[cell[1]], flat.X[cell[2]], flat.X[cell[3]]});
    if (box[0] < -0.5 - 1e-9 || box[2] > 0.5 + 1e-9 || box[1] < -0.2 - 1e-9) continue;
    ++rows;
    EXPECT_NEAR(box[2] - box[0], 0.01, 1e-9);
    EXPECT_NEAR(box[3] - box[1], 0.01, 1e-9);
  }
  EXPECT_EQ(rows, 100 * 20);
}

// Two fine zones of one contact must each be meshed as it would be alone: the same nodes on the face, the same rows
// beneath it.
TEST(meshing, each_of_two_fine_zones) {
  GeometryOptions options;
  options.files = {temporary_file("wide.geo", "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {-6, -3, 0, 12, 3};\n")};
  options.bodies = {body_at("flat", 0, -1)};
  options.bodies[0].mesh = {CellKind::quad4, 0.5, 1.3};
  const FineZone left{{"flat"}, {-3, 0}, 0.5, 0.2, 0.05, 0.0, "pad", "contact.pad.fine_zone[0]"};
  const FineZone right{{"flat"}, {2.5, 0}, 1.0, 0.3, 0.1, 0.0, "pad", "contact.pad.fine_zone[1]"};
  const auto nodes_of = [&](std::vector<FineZone> zones, const FineZone& zone) {
    options.fine_zones = std::move(zones);
    const mesh::Mesh mesh = build(options).bodies[0];
    EXPECT_GT(mesh::poorest_cell(mesh).scaled_jacobian, 0.3);
    std::vector<std::array<double, 2>> nodes;
    for (const Vec2& X : mesh.X)
      if (std::abs(X.x() - zone.centre_mm.x()) < zone.half_width_mm + 1e-9 && X.y() > -zone.depth_mm - 1e-9)
        nodes.push_back({std::round(1e9 * X.x()), std::round(1e9 * X.y())});
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  };
  for (const auto& zone : {left, right}) {
    const auto alone = nodes_of({zone}, zone);
    const auto across = static_cast<std::size_t>(std::lround(2.0 * zone.half_width_mm / zone.size_mm)) + 1;
    EXPECT_GE(alone.size(), across * 3);
    EXPECT_EQ(alone, nodes_of({left, right}, zone));
  }
}

// A body must not be made fine by a zone of its contact that lies at another body, where one of its own is near.
TEST(meshing, a_zone_refines_where_it_lies) {
  GeometryOptions options;
  options.files = {temporary_file("feet.geo",
                                  "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {-6, -1, 0, 12, 1};\n"
                                  "Rectangle(2) = {-5, 0, 0, 4, 1};\nRectangle(3) = {1, 0, 0, 4, 1};\n")};
  options.bodies = {body_at("flat", 0, -0.5), body_at("left", -3, 0.5), body_at("right", 3, 0.5)};
  for (BodyOptions& each : options.bodies) each.mesh = {CellKind::quad4, 0.5, 1.3};
  const std::vector<std::string> all{"flat", "left", "right"};
  options.fine_zones = {{all, {-3, 0}, 0.5, 0.2, 0.05, 0.0, "pad"}, {all, {3, 0}, 0.5, 0.2, 0.1, 0.0, "pad"}};
  const Geometry geometry = build(options);
  for (int b : {1, 2}) ASSERT_EQ(geometry.drawings[b].zones.size(), 1U);
  EXPECT_EQ(geometry.drawings[0].zones.size(), 2U);
  EXPECT_EQ(geometry.drawings[1].zones[0].size_mm, 0.05);
  EXPECT_EQ(geometry.drawings[2].zones[0].size_mm, 0.1);
  options.fine_zones[1].centre_mm = {3, 40};
  options.fine_zones[1].bodies = {"flat"};
  EXPECT_EQ(issues_of(options), ".centre_mm = [3, 40]: no edge of a body passes through the fine zone");
  options.fine_zones = {options.fine_zones[1]};
  EXPECT_EQ(issues_of(options), "") << "alone, a zone that names its bodies refines them from far away";
}

// The area of the half disc must approach pi R^2 / 2 at second order in the element size.
TEST_P(Kinds, area_error_falls_at_rate_two) {
  const double exact = 18.0 * std::numbers::pi;
  std::vector<double> errors;
  for (double size : {0.8, 0.4, 0.2, 0.1}) {
    const Geometry geometry = build(cylinder_on_flat(GetParam(), size, 0.0));
    EXPECT_NEAR(geometry.facts[0].area_mm2, exact, 1e-9);
    EXPECT_NEAR(mesh::area(geometry.bodies[1]), 72.0, 1e-10);
    errors.push_back(exact - mesh::area(geometry.bodies[0]));
  }
  EXPECT_NEAR(std::log2(errors.front() / errors.back()) / 3.0, 2.0, 0.1);
}

// Nodes on a curved edge must lie on it.
TEST(meshing, nodes_lie_on_the_circle) {
  const Geometry geometry = build(cylinder_on_flat(CellKind::quad4, 0.8, 0.01));
  const mesh::Mesh& cylinder = geometry.bodies[0];
  for (int node : mesh::nodes_of(cylinder.boundaries.at("round")))
    EXPECT_NEAR((cylinder.X[node] - Vec2(0, 6)).norm(), 6.0, 1e-9);
}

// Boundaries must follow the outline with the body on the left, consecutive edges in one chain.
TEST(meshing, chains_have_the_body_on_the_left) {
  const Geometry geometry = build(cylinder_on_flat(CellKind::quad4, 0.8, 0.0));
  const auto ends = [&](int b, const std::string& name) {
    const mesh::Boundary& chains = geometry.bodies[b].boundaries.at(name);
    EXPECT_EQ(chains.size(), 1u) << name;
    return std::pair{geometry.bodies[b].X[chains[0].front()], geometry.bodies[b].X[chains[0].back()]};
  };
  const auto near = [](const std::pair<Vec2, Vec2>& a, const Vec2& begin, const Vec2& end) {
    return (a.first - begin).norm() + (a.second - end).norm() < 1e-9;
  };
  EXPECT_TRUE(near(ends(0, "round"), {-6, 6}, {6, 6}));
  EXPECT_TRUE(near(ends(0, "top"), {6, 6}, {-6, 6}));
  EXPECT_TRUE(near(ends(1, "face"), {6, 0}, {-6, 0}));
  EXPECT_TRUE(near(ends(1, "bottom"), {-6, -6}, {6, -6}));
}

// Bodies that touch along an edge must keep nodes of their own there.
TEST(meshing, touching_bodies_are_not_merged) {
  GeometryOptions options;
  options.files = {scene_file("sliding_block/blocks.geo")};
  options.bodies = {body("slider"), body("base")};
  options.bodies[0].mesh.far_size_mm = 0.5;
  options.bodies[1].mesh.far_size_mm = 0.7;
  const Geometry geometry = build(options);
  EXPECT_EQ(mesh::nodes_of(geometry.bodies[0].boundaries.at("slider_bottom")).size(), 21u);
  EXPECT_EQ(mesh::nodes_of(geometry.bodies[1].boundaries.at("base_top")).size(), 15u);
  EXPECT_EQ(mesh::poorest_cell(geometry.bodies[0]).scaled_jacobian, 1.0) << "a plain rectangle has a plain grid";
}

// The mesh of one body must not depend on the other bodies of the scene.
TEST(meshing, bodies_are_meshed_apart) {
  GeometryOptions both = cylinder_on_flat(CellKind::quad4, 0.8, 0.02);
  const Geometry geometry = build(both);
  both.bodies[0].mesh.far_size_mm = 0.4;
  EXPECT_EQ(build(both).bodies[1].X, geometry.bodies[1].X);
}

// Bodies of one scene may have cells of different kinds.
TEST(meshing, kinds_differ_between_bodies) {
  GeometryOptions options = cylinder_on_flat(CellKind::quad4, 0.8, 0.02);
  options.bodies[0].mesh.element = CellKind::tri3;
  const Geometry geometry = build(options);
  EXPECT_EQ(geometry.bodies[0].kind, CellKind::tri3);
  EXPECT_EQ(geometry.bodies[1].kind, CellKind::quad4);
}

// A rigid body must have its outline, fine in the zone, and its boundaries, but no cells.
TEST(meshing, rigid_body_is_its_outline) {
  GeometryOptions options = cylinder_on_flat(CellKind::quad4, 0.8, 0.01);
  options.bodies[0].rigid = true;
  const Geometry geometry = build(options);
  const mesh::Mesh& cylinder = geometry.bodies[0];
  EXPECT_EQ(cylinder.cell_count(), 0);
  EXPECT_EQ(cylinder.node_count() + 1, static_cast<int>(cylinder.outline[0].size()));
  EXPECT_NEAR(spacing(cylinder, "round", 0.5).largest, 0.01, 0.0005);
  EXPECT_NEAR(mesh::area(cylinder), 18.0 * std::numbers::pi, 0.3);
}

// Two calls must give the same bytes.
TEST_P(Kinds, repeats_to_the_byte) {
  const GeometryOptions options = cylinder_on_flat(GetParam(), 0.8, 0.02);
  const Geometry first = build(options), second = build(options);
  for (std::size_t b = 0; b < first.bodies.size(); ++b) {
    ASSERT_EQ(first.bodies[b].X.size(), second.bodies[b].X.size());
    EXPECT_EQ(std::memcmp(first.bodies[b].X.data(), second.bodies[b].X.data(), first.bodies[b].X.size() * sizeof(Vec2)),
              0);
    EXPECT_EQ(first.bodies[b].cells, second.bodies[b].cells);
    EXPECT_EQ(first.bodies[b].boundaries, second.bodies[b].boundaries);
  }
}

// A zone that reaches past the corners of a narrow body must refine its face only up to them.
TEST(meshing, fine_zone_ends_at_corners) {
  GeometryOptions options;
  options.files = {scene_file("sliding_block/wider_base.geo")};
  options.bodies = {body("slider"), body("base")};
  options.fine_zones = {{{}, {5, 0}, 6.0, 0.3, 0.1, 0.0}};
  const Geometry geometry = build(options);
  EXPECT_EQ(mesh::nodes_of(geometry.bodies[0].boundaries.at("slider_bottom")).size(), 101u);
  EXPECT_LT(mesh::nodes_of(geometry.bodies[0].boundaries.at("slider_left")).size(), 40u);
  EXPECT_GT(mesh::poorest_cell(geometry.bodies[0]).scaled_jacobian, 0.4);
}

// A zone that stands upright must refine an upright face.
TEST(meshing, fine_zone_along_an_angle) {
  GeometryOptions options;
  options.files = {scene_file("sliding_block/blocks.geo")};
  options.bodies = {body("slider")};
  options.fine_zones = {{{}, {10, 2.5}, 0.5, 0.2, 0.05, 90.0}};
  const mesh::Mesh mesh = build(options).bodies[0];
  int fine = 0;
  for (int node : mesh::nodes_of(mesh.boundaries.at("slider_right"))) fine += std::abs(mesh.X[node].y() - 2.5) < 0.501;
  EXPECT_EQ(fine, 21);
}

// A ring much thinner than the elements asked for must still be meshed, by smaller ones.
TEST(meshing, thin_ring) {
  const std::string path = temporary_file(
      "ring.geo",
      "SetFactory(\"OpenCASCADE\"); Disk(1) = {0, 0, 0, 10}; Disk(2) = {0, 0, 0, 9.9};"
      "BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; }; Physical Surface(\"ring\") = {3};\n");
  GeometryOptions options;
  options.files = {path};
  options.bodies = {body("ring")};
  options.bodies[0].mesh.far_size_mm = 3.0;
  for (CellKind kind : {CellKind::tri3, CellKind::quad4}) {
    options.bodies[0].mesh.element = kind;
    const Geometry geometry = build(options);
    EXPECT_NEAR(mesh::area(geometry.bodies[0]), std::numbers::pi * 1.99, 0.15);
    EXPECT_EQ(geometry.bodies[0].outline.size(), 2u);
  }
}

}  // namespace
