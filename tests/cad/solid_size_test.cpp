#include <cmath>
#include <csignal>
#include <numbers>
#include <random>
#include <set>

#include "cad/solid/solid_bytes.hpp"
#include "cad/solid/solid_file.hpp"
#include "cad/solid/solid_size.hpp"
#include "cad/solid/triangles.hpp"
#include "solid_support.hpp"
#include "support/children.hpp"

namespace {

using namespace reye;
using namespace reye::cad;
using base::Vec3;

Points3 random_points(int count, double extent) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> along(-extent, extent);
  Points3 points;
  for (int k = 0; k < count; ++k) points.emplace_back(along(random), along(random), along(random));
  return points;
}

// The size by the tree of points must be that of a search through all of them.
TEST(solid_size, tree_of_points) {
  std::vector<SizePoint> points;
  double size = 0.1;
  for (const Vec3& p : random_points(500, 10.0)) points.push_back({p, size = std::fmod(size * 1.7, 3.0) + 0.05});
  const SizeZone zone{Vec3(1, 2, 3), 0.0, Vec3(1, 0.5, 2), 0.07};
  const SolidSize tree(2.0, 1.3, {zone}, points);
  for (const Vec3& p : random_points(300, 12.0)) {
    double expected = std::min(2.0, 0.07 + 0.3 * zone.distance(p));
    for (const SizePoint& point : points) expected = std::min(expected, point.size + 0.3 * (point.at - p).norm());
    EXPECT_NEAR(tree(p), expected, 1e-14);
  }
}

// A ball and a box must be no distance inside and the right one outside.
TEST(solid_size, distance_from_zones) {
  const SizeZone ball{Vec3(1, 0, 0), 2.0, Vec3::Zero(), 0.1}, box{Vec3(1, 0, 0), 0.0, Vec3(1, 2, 3), 0.1};
  EXPECT_EQ(ball.distance({2.9, 0, 0}), 0.0);
  EXPECT_NEAR(ball.distance({1, 3, 4}), 3.0, 1e-14);
  EXPECT_EQ(box.distance({1.9, 1.9, -2.9}), 0.0);
  EXPECT_NEAR(box.distance({5, 2, 7}), 5.0, 1e-14);
}

/// The mean length of the edges of facets within the ball round the origin.
double mean_edge_within(const mesh::SolidMesh& mesh, double reach) {
  double sum = 0.0;
  int count = 0;
  for (const mesh::Facet& facet : mesh.skin) {
    const Vec3 p[3] = {mesh.X[facet.nodes[0]], mesh.X[facet.nodes[1]], mesh.X[facet.nodes[2]]};
    if (p[0].norm() > reach || p[1].norm() > reach || p[2].norm() > reach) continue;
    for (int k = 0; k < 3; ++k, ++count) sum += (p[(k + 1) % 3] - p[k]).norm();
  }
  return sum / count;
}

SolidGeometryOptions fine_ball(double size) {
  SolidGeometryOptions options =
      solid_options({solid_scene("ball_on_flat/ball_on_flat.geo")},
                    {solid_body("ball", mesh::SolidKind::tet4), solid_body("flat", mesh::SolidKind::tet4)});
  options.fine_zones = {{{}, Vec3::Zero(), 4.0, Vec3::Zero(), size, "c", "contact.c.fine_zone"}};
  return options;
}

// Facets in a fine zone must have the size asked for, and far away that of the body; neighbouring cells of all sizes
// must stay sound.
TEST(solid_size, fine_zone) {
  for (double size : {0.5, 0.25}) {
    const SolidGeometry geometry = build_solids(fine_ball(size));
    for (const mesh::SolidMesh& mesh : geometry.bodies) {
      EXPECT_NEAR(mean_edge_within(mesh, 4.0), size, 0.1 * size);
      EXPECT_GT(poorest_jacobian(mesh), 0.1);
      EXPECT_LT(mesh.node_count(), 6000);
    }
  }
}

// The estimate of nodes must be right within a third.
TEST(solid_size, estimate_of_nodes) {
  const SolidGeometry geometry = build_solids(fine_ball(0.2));
  for (int b : {0, 1}) {
    const SolidBox& box = geometry.facts[b].box_mm;
    const double diagonal = Vec3(box[3] - box[0], box[4] - box[1], box[5] - box[2]).norm();
    const SolidOrder order{{}, false, false, diagonal / 15.0, 1.3, {{Vec3::Zero(), 4.0, Vec3::Zero(), 0.2}}};
    const double estimate = estimated_solid_nodes(geometry.facts[b].volume_mm3, box, order);
    EXPECT_NEAR(estimate / geometry.bodies[b].node_count(), 1.0, 0.33);
  }
}

// A zone beside every body and a mesh of millions of nodes must be refused with their keys.
TEST(solid_size, refusals) {
  SolidGeometryOptions options = fine_ball(0.5);
  options.fine_zones[0].centre_mm = Vec3(-10, 0, 0);
  EXPECT_NE(solid_issues(options).find("contact.c.fine_zone.centre_mm = [-10, 0, 0]: no body reaches"),
            std::string::npos);
  options = fine_ball(0.01);
  EXPECT_NE(solid_issues(options).find("body.flat: would need about"), std::string::npos);
}

// A zone of a curved face must count as reached where only the exact face, not its coarse triangles, is that near.
TEST(solid_size, small_zone_on_a_curved_face) {
  SolidGeometryOptions options = solid_options({solid_scene("ball_on_flat/ball.step")}, {solid_body("ball")});
  const Vec3 on_ball = Vec3(0, 0, 50) + 50.0 * Vec3(1, 1, -2).normalized();
  options.fine_zones = {{{"ball"}, on_ball, 0.02, Vec3::Zero(), 0.01, "c", "contact.c.fine_zone"}};
  EXPECT_EQ(solid_issues(options), "");
}

// A coarse wish must not keep curved faces from being resolved, nor thin walls from being meshed.
TEST(solid_size, curved_faces) {
  SolidGeometryOptions options = solid_options({solid_scene("pin_in_bush/pin_in_bush.geo")},
                                               {solid_body("pin"), solid_body("bush", mesh::SolidKind::tet4)});
  for (SolidBodyOptions& each : options.bodies) each.mesh.far_size_mm = 50.0;
  const SolidGeometry geometry = build_solids(options);
  EXPECT_NEAR(meshed_area(geometry.bodies[0], "pin_contact"), 14.0 * std::numbers::pi * 9.95, 0.1);
  EXPECT_NEAR(meshed_area(geometry.bodies[1], "bush_contact"), 100.0 * std::numbers::pi, 3.0);
  for (const mesh::SolidMesh& mesh : geometry.bodies) EXPECT_GT(poorest_jacobian(mesh), 0.1);
}

std::vector<Triangle> unit_cube() {
  const SolidGeometry geometry =
      build_solids(solid_options({solid_data("hex8.msh")}, {solid_body("block")}));  // 2 x 1 x 1
  return triangles_of(geometry.bodies[0].X, geometry.bodies[0].skin);
}

// Winding numbers must be one inside and zero outside; the nearest point must be on the face, edge or corner it is on.
TEST(solid_size, triangles) {
  const std::vector<Triangle> cube = unit_cube();
  EXPECT_NEAR(area_of(cube), 10.0, 1e-12);
  EXPECT_NEAR(winding_number(cube, {0.1, 0.9, 0.5}), 1.0, 1e-12);
  EXPECT_NEAR(winding_number(cube, {0.1, 1.1, 0.5}), 0.0, 1e-12);
  EXPECT_LT((nearest_on(cube, {1.3, 0.4, 3.0}) - Vec3(1.3, 0.4, 1.0)).norm(), 1e-14);
  EXPECT_LT((nearest_on(cube, {3.0, 0.4, 3.0}) - Vec3(2.0, 0.4, 1.0)).norm(), 1e-14);
  EXPECT_LT((nearest_on(cube, {3.0, 2.0, 3.0}) - Vec3(2.0, 1.0, 1.0)).norm(), 1e-14);
}

// Curved edges that would turn a cell inside out must be straightened, and only those.
TEST(solid_size, bad_cells_are_straightened) {
  RawSolidMesh mesh;
  mesh.kind = mesh::SolidKind::tet10;
  mesh.nodes = {{0, 0, 0},     {1, 0, 0},   {0, 1, 0},   {0, 0, 1},     {0.5, 0, 0},
                {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  mesh.cells = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
  EXPECT_NEAR(least_jacobian(mesh.nodes, mesh.kind, mesh.cells[0]), 1.0, 1e-14);
  mesh.nodes[4] = Vec3(0.5, 0.05, 0.05);
  EXPECT_EQ(straighten_bad_cells(mesh), 0);
  mesh.nodes[4] = Vec3(0.5, 0.4, 0.4);
  EXPECT_LT(least_jacobian(mesh.nodes, mesh.kind, mesh.cells[0]), 0.0);
  EXPECT_EQ(straighten_bad_cells(mesh), 1);
  EXPECT_NEAR(least_jacobian(mesh.nodes, mesh.kind, mesh.cells[0]), 1.0, 1e-14);
}

// Bytes that were cut or changed must end in an error, never in a mesh that refers beside itself.
TEST(solid_size, answers_are_checked) {
  SolidMeshAnswer answer;
  answer.mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  answer.mesh.facets = {{mesh::FacetKind::tri3, {0, 1, 2, -1, -1, -1}, 0}};
  const std::string good = bytes_of(answer);
  EXPECT_EQ(solid_mesh_answer_of(good, 1).mesh.nodes.size(), 3u);
  EXPECT_THROW(solid_mesh_answer_of(good, 0), std::runtime_error);
  for (std::size_t cut = 0; cut < good.size(); cut += 5)
    EXPECT_THROW(solid_mesh_answer_of(good.substr(0, cut), 1), std::runtime_error);
  answer.mesh.facets[0].nodes[2] = 3;
  EXPECT_THROW(solid_mesh_answer_of(bytes_of(answer), 1), std::runtime_error);
  answer.mesh.facets[0].nodes[2] = 2;
  answer.mesh.nodes[1].x() = std::nan("");
  EXPECT_THROW(solid_mesh_answer_of(bytes_of(answer), 1), std::runtime_error);
}

// An importer that crashes while it meshes must leave an error with the reason, and this program alive.
TEST(solid_size, crash_while_meshing) {
  const SolidGeometryOptions options = solid_options({solid_scene("ball_on_flat/flat.step")}, {});
  const std::set<pid_t> others = support::children();
  SolidFile file(options.files[0], options);
  std::vector<base::Issue> issues;
  const std::vector<RawSolid> solids = file.solids({}, issues);
  ASSERT_EQ(solids.size(), 1u);
  std::set<pid_t> started = support::children();
  for (pid_t other : others) started.erase(other);
  ASSERT_EQ(started.size(), 1u);
  ASSERT_EQ(::kill(*started.begin(), SIGSEGV), 0);
  try {
    file.mesh({solids[0].volumes, false, false, 10.0, 1.3, {}}, 6);
    FAIL() << "a mesh by a program that has ended";
  } catch (const base::MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("the program that meshes it crashes on it"), std::string::npos);
  }
}

// An order that gmsh cannot carry out must come back with a reason, and the next one be answered.
TEST(solid_size, order_that_fails) {
  const SolidGeometryOptions options = solid_options({solid_scene("ball_on_flat/flat.step")}, {});
  SolidFile file(options.files[0], options);
  std::vector<base::Issue> issues;
  const std::vector<RawSolid> solids = file.solids({}, issues);
  ASSERT_EQ(solids.size(), 1u);
  SolidOrder order{{99}, false, false, 10.0, 1.3, {}};
  EXPECT_THROW(file.mesh(order, 6), base::MeshError);
  order.volumes = solids[0].volumes;
  EXPECT_GT(file.mesh(order, 6).cells.size(), 100u);
}

}  // namespace
