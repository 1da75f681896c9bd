#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/meshes.hpp"
#include "support/surfaces.hpp"

namespace {

using namespace reye;
using base::Points;
using base::Vec2;
using base::Vector;
using body::ContactIndex;
using mesh::CellKind;

/// A block of second order with curved sides.
mesh::Mesh bent_block(CellKind kind) {
  return support::mapped(support::rectangle({.size = {2, 1}, .nx = 3, .ny = 2, .kind = kind}), [](const Vec2& x) {
    return Vec2(x.x() + 0.1 * x.y() * x.y(), x.y() * (1.0 + 0.2 * std::sin(2.0 * x.x())));
  });
}

/// Contact on top and bottom; the bottom is a rigid edge, the left side is held along x.
body::BodyInput input_of() {
  auto in = support::elastic(1000.0, 0.3);
  in.contact_boundaries = {"top", "bottom"};
  body::Support base;
  base.name = "base";
  base.edge = "bottom";
  base.rigid = true;
  base.x = base.y = base.rotation = support::moved(0.1);
  body::Support side;
  side.name = "side";
  side.edge = "left";
  side.x = support::moved(0.05);
  in.supports = {base, side};
  return in;
}

/// Positions of all nodes under u, mid nodes of contact boundaries replaced by their control points.
Points seen(const mesh::Mesh& m, const body::BodyInput& in, const std::vector<Vec2>& u) {
  Points x = m.X;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += u[k];
  return mesh::control_points(body::curved_edges(m, in.contact_boundaries), x);
}

template <class Body>
void expect_positions(const Body& b, const Vector& q, const Points& x) {
  for (std::size_t k = 0; k < b.contact_nodes().size(); ++k)
    EXPECT_LT((b.position(ContactIndex(k), q).x - x[b.contact_nodes()[k]]).norm(), 1e-12)
        << "node " << b.contact_nodes()[k];
}

// Contact must see the control points of the displaced edges: of a linear body, a nonlinear one whose rigid edge turns,
// and a rigid one.
TEST(control_points, are_those_of_the_displaced_edges) {
  for (CellKind kind : {CellKind::tri6, CellKind::quad8}) {
    const auto mesh = bent_block(kind);
    const auto shape = body::make_shape(mesh);
    auto in = input_of();
    EXPECT_EQ(body::curved_edges(mesh, in.contact_boundaries).size(), 6u);
    const body::LinearBody linear(shape, in);
    const Vector q = 0.1 * support::random_direction(linear.dofs(), 1);
    expect_positions(linear, q, seen(mesh, in, linear.recover(q, {})));
    in.kinematics = base::Kinematics::finite;
    const body::NonlinearBody finite(shape, in);
    const auto y = finite.start().y;
    expect_positions(finite, q, seen(mesh, in, finite.recover(q, y)));
    in.supports.clear();
    const body::RigidBody rigid(shape, in);
    const Vector motion = Vector::Constant(3, 0.4);
    expect_positions(rigid, motion, seen(mesh, in, rigid.recover(motion, {})));
  }
}

// The columns of a contact node must move the point that contact sees as its terms say.
TEST(control_points, move_by_their_terms) {
  const auto mesh = bent_block(CellKind::quad8);
  const auto in = input_of();
  const body::LinearBody b(body::make_shape(mesh), in);
  const Vector q = 0.1 * support::random_direction(b.dofs(), 2);
  for (int k = 0; k < static_cast<int>(b.contact_nodes().size()); ++k) {
    const auto p = b.position(ContactIndex(k), q);
    for (int t = 0; t < p.count; ++t) {
      Vector other = q;
      other[p.terms[t].column] += 1.0;
      const Points x = seen(mesh, in, b.recover(other, {}));
      EXPECT_LT((x[b.contact_nodes()[k]] - p.x - p.terms[t].direction).norm(), 1e-12);
    }
  }
}

// Seated on nodal displacements a body must give these back at all nodes of its contact boundaries.
TEST(control_points, are_seated_on_nodal_displacements) {
  const auto mesh = bent_block(CellKind::tri6);
  auto in = input_of();
  in.supports.clear();
  const body::LinearBody b(body::make_shape(mesh), in);
  std::vector<Vec2> u;
  for (int node : b.contact_nodes()) u.push_back(0.1 * Vec2(std::sin(3.0 * node), std::cos(5.0 * node)));
  Vector q = Vector::Zero(b.dofs());
  body::seat(b, u, q);
  const auto back = b.recover(q, {});
  for (std::size_t k = 0; k < u.size(); ++k) EXPECT_LT((back[b.contact_nodes()[k]] - u[k]).norm(), 1e-12);
  const body::NonlinearBody finite(body::make_shape(mesh), in);
  Vector p = Vector::Zero(finite.dofs());
  auto y = finite.start().y;
  finite.seat(back, p, y);
  const auto again = finite.recover(p, y);
  for (std::size_t node = 0; node < back.size(); ++node) EXPECT_LT((again[node] - back[node]).norm(), 1e-12);
}

}  // namespace
