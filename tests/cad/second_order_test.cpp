#include "mesh/second_order.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "support.hpp"
#include "support/meshes.hpp"

namespace reye::cad {

namespace {

using mesh::CellKind;

GeometryOptions second_order_cylinder(CellKind kind, double far_size, double fine_size) {
  GeometryOptions options = cylinder_on_flat(kind, far_size, fine_size);
  for (BodyOptions& each : options.bodies) each.mesh.order = 2;
  return options;
}

class SecondOrder : public testing::TestWithParam<CellKind> {};
INSTANTIATE_TEST_SUITE_P(meshing, SecondOrder, testing::Values(CellKind::tri3, CellKind::quad4));

// Without its mid nodes a mesh of second order must be that of first order, node by node.
TEST_P(SecondOrder, vertices_are_those_of_first_order) {
  const Geometry linear = build(cylinder_on_flat(GetParam(), 0.8, 0.05));
  const Geometry second = build(second_order_cylinder(GetParam(), 0.8, 0.05));
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(second.bodies[b].kind, GetParam() == CellKind::tri3 ? CellKind::tri6 : CellKind::quad8);
    const mesh::Mesh vertices = mesh::to_first_order(second.bodies[b]);
    EXPECT_EQ(vertices.X, linear.bodies[b].X);
    EXPECT_EQ(vertices.cells, linear.bodies[b].cells);
    EXPECT_EQ(vertices.boundaries, linear.bodies[b].boundaries);
  }
}

// Mid nodes must lie on the circle and its polygon of parabolas fill it at fourth order; inner edges stay straight.
TEST_P(SecondOrder, mid_nodes_lie_on_the_circle) {
  std::vector<double> errors;
  for (double size : {0.8, 0.4, 0.2}) {
    const mesh::Mesh cylinder = build(second_order_cylinder(GetParam(), size, 0.0)).bodies[0];
    const mesh::Chain& round = cylinder.boundaries.at("round").front();
    ASSERT_EQ(round.size() % 2, 1u);
    for (int node : round) EXPECT_NEAR((cylinder.X[node] - Vec2(0, 6)).norm(), 6.0, 1e-10);
    for (std::size_t i = 1; i + 1 < round.size(); i += 2) {
      const Vec2 &a = cylinder.X[round[i - 1]], &m = cylinder.X[round[i]], &b = cylinder.X[round[i + 1]];
      EXPECT_NEAR((m - a).norm(), (b - m).norm(), 1e-7);
    }
    const int n = mesh::corners(cylinder.kind);
    const std::vector<int> on_circle = mesh::nodes_of(cylinder.boundaries.at("round"));
    for (const mesh::Cell& cell : cylinder.cells)
      for (int k = 0; k < n; ++k) {
        if (std::find(on_circle.begin(), on_circle.end(), cell[n + k]) != on_circle.end()) continue;
        const Vec2 middle = 0.5 * (cylinder.X[cell[k]] + cylinder.X[cell[(k + 1) % n]]);
        EXPECT_LT((cylinder.X[cell[n + k]] - middle).norm(), 1e-14);
      }
    errors.push_back(std::abs(18.0 * std::numbers::pi - mesh::area(cylinder)));
  }
  EXPECT_NEAR(std::log2(errors.front() / errors.back()) / 2.0, 4.0, 0.2);
}

// A rigid body of second order must be an outline with mid nodes.
TEST(second_order, rigid_outline) {
  GeometryOptions options = second_order_cylinder(CellKind::quad4, 0.8, 0.0);
  options.bodies[0].rigid = true;
  const mesh::Mesh cylinder = build(options).bodies[0];
  EXPECT_TRUE(cylinder.cells.empty());
  EXPECT_EQ(mesh::order(cylinder.kind), 2);
  EXPECT_NEAR(mesh::area(cylinder), 18.0 * std::numbers::pi, 1e-3);
  for (int node : mesh::nodes_of(cylinder.boundaries.at("round")))
    EXPECT_NEAR((cylinder.X[node] - Vec2(0, 6)).norm(), 6.0, 1e-10);
}

// An outline of second order must keep all its nodes when it is refilled, mid nodes moved off the curve included.
TEST(second_order, refill_keeps_the_outline) {
  const Geometry geometry = build(second_order_cylinder(CellKind::quad4, 0.8, 0.1));
  mesh::Mesh worn = geometry.bodies[0];
  for (int node : mesh::nodes_of(worn.boundaries.at("round")))
    worn.X[node] += 1e-3 * std::cos(worn.X[node].x()) * Vec2(0, 1);
  const mesh::Mesh fresh = refill(geometry.drawings[0], worn);
  mesh::check(fresh);
  EXPECT_EQ(fresh.kind, CellKind::quad8);
  for (const char* name : {"round", "top"}) {
    const mesh::Chain &was = worn.boundaries.at(name).front(), &is = fresh.boundaries.at(name).front();
    ASSERT_EQ(was.size(), is.size());
    for (std::size_t i = 0; i < was.size(); ++i) EXPECT_EQ(worn.X[was[i]], fresh.X[is[i]]);
  }
  EXPECT_NEAR(mesh::area(remesh(geometry.drawings[0])), mesh::area(geometry.bodies[0]), 1e-9);
}

/// The file of a mesh of second order: every other cell clockwise, its boundaries physical curves, with centre nodes
/// (gmsh type 10) where asked for.
std::string msh(const mesh::Mesh& m, bool centres) {
  std::ostringstream text;
  text.precision(17);
  const int n = mesh::corners(m.kind), type = n == 3 ? 9 : centres ? 10 : 16;
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << m.boundaries.size() + 1 << "\n2 1 \"plate\"\n";
  int tag = 2;
  for (const auto& [name, chains] : m.boundaries) text << "1 " << tag++ << " \"" << name << "\"\n";
  text << "$EndPhysicalNames\n$Nodes\n" << m.node_count() + (centres ? m.cell_count() : 0) << "\n";
  for (int k = 0; k < m.node_count(); ++k) text << k + 1 << " " << m.X[k].x() << " " << m.X[k].y() << " 0\n";
  for (int c = 0; centres && c < m.cell_count(); ++c) {
    const Vec2 centre = 0.25 * (m.X[m.cells[c][4]] + m.X[m.cells[c][5]] + m.X[m.cells[c][6]] + m.X[m.cells[c][7]]);
    text << m.node_count() + c + 1 << " " << centre.x() << " " << centre.y() << " 0\n";
  }
  std::ostringstream elements;
  int count = 0;
  tag = 2;
  for (const auto& [name, chains] : m.boundaries) {
    const mesh::Chain& chain = chains.front();
    for (std::size_t i = 0; i + 2 < chain.size(); i += 2)
      elements << ++count << " 8 2 " << tag << " " << tag << " " << chain[i] + 1 << " " << chain[i + 2] + 1 << " "
               << chain[i + 1] + 1 << "\n";
    ++tag;
  }
  for (int c = 0; c < m.cell_count(); ++c) {
    const mesh::Cell& cell = m.cells[c];
    elements << ++count << " " << type << " 2 1 1";
    for (int k = 0; k < n; ++k) elements << " " << cell[c % 2 == 0 ? k : n - 1 - k] + 1;
    for (int k = 0; k < n; ++k) elements << " " << cell[c % 2 == 0 || k == n - 1 ? n + k : n + n - 2 - k] + 1;
    if (centres) elements << " " << m.node_count() + c + 1;
    elements << "\n";
  }
  text << "$EndNodes\n$Elements\n" << count << "\n" << elements.str() << "$EndElements\n";
  return text.str();
}

// A mesh file of second order must come in with all its nodes but centre ones, and its curved edges as boundaries.
TEST(second_order, mesh_files) {
  for (const auto& [kind, centres] :
       {std::pair{CellKind::tri6, false}, {CellKind::quad8, false}, {CellKind::quad8, true}}) {
    const mesh::Mesh made = support::ring({1.0, 2.0, 1.2, 3, 4, kind});
    GeometryOptions options;
    options.files = {temporary_file("second_order.msh", msh(made, centres))};
    options.bodies = {body("plate")};
    for (const char* name : {"left", "right", "top", "bottom"}) options.boundaries.push_back(boundary(name, "plate"));
    const mesh::Mesh read = build(options).bodies[0];
    EXPECT_EQ(read.kind, kind);
    EXPECT_EQ(read.node_count(), made.node_count());
    EXPECT_NEAR(mesh::area(read), mesh::area(made), 1e-13);
    for (const auto& [name, chains] : made.boundaries)
      EXPECT_NEAR(mesh::length(read.X, read.boundaries.at(name), 2), mesh::length(made.X, chains, 2), 1e-13) << name;
  }
}

// Where second order is asked for, a mesh file of first order must get straight edges with mid nodes.
TEST(second_order, mesh_file_of_first_order) {
  GeometryOptions options;
  options.files = {data("plate.msh")};
  options.bodies = {body_at("plate", 3, 1)};
  const Geometry linear = build(options);
  options.bodies[0].mesh.order = 2;
  const Geometry second = build(options);
  EXPECT_EQ(mesh::order(second.bodies[0].kind), 2);
  EXPECT_NEAR(mesh::area(second.bodies[0]), mesh::area(linear.bodies[0]), 1e-13);
  EXPECT_EQ(mesh::to_first_order(second.bodies[0]).cells, linear.bodies[0].cells);
}

}  // namespace

}  // namespace reye::cad
