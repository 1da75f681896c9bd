#include <gtest/gtest.h>

#include "solver/solid/turning_motion.hpp"
#include "support/solid_problem.hpp"

using namespace reye;
using base::Matrix;
using base::Vec3;
using base::Vector;

namespace {

Vector waves(Eigen::Index n, double size) {
  return size * Vector::LinSpaced(n, 0.3, 0.3 + 1.7 * static_cast<double>(n)).array().sin().matrix();
}

/// Two blocks that turn: the lower one on a holder with a free and a driven rotation, the upper one held by contact.
solver::SolidSystem turning_blocks() {
  auto lower = support::solid("lower", support::block(mesh::SolidKind::hex8, {2, 2, 1}, Vec3::Ones()), 1000.0, 0.3);
  auto holder =
      support::by_node("holder", "z0", {support::fixed_motion(), support::loaded(1.0, ""), support::moved(1.0, "")});
  holder.rigid = true;
  holder.about = {support::fixed_motion(), {}, support::moved(1.0, "")};
  lower.supports = {holder};
  auto upper = support::solid(
      "upper", support::block(mesh::SolidKind::hex8, {2, 1, 1}, Vec3::Ones(), support::box({0, 0, 1}, {1, 1, 2})),
      500.0, 0.2);
  body::SolidLoad load;
  load.face = "z1";
  load.pressure_MPa = 3.0;
  load.traction_MPa = Vec3(1, -2, 0.5);
  upper.loads = {load};
  lower.contact_faces = {"z1"};
  upper.contact_faces = {"z0"};
  std::vector<body::SolidBody> bodies;
  std::vector<std::optional<body::SolidTurning>> turning;
  contact::Columns columns;
  std::vector<const mesh::SolidMesh*> meshes;
  int next = 0;
  const std::vector<body::SolidInput> inputs{lower, upper};
  for (std::size_t b = 0; b < 2; ++b) {
    const auto& input = inputs[b];
    const auto nodes = mesh::nodes_of(mesh::facets_of(*input.mesh, b == 0 ? "z1" : "z0"));
    const auto pivot = body::solid_pivot(input);
    bodies.emplace_back(body::in_frame(input, *pivot), nodes);
    turning.push_back(body::make_turning(input, *pivot, nodes));
    columns.emplace_back(input.mesh->X.size(), -1);
    for (const int node : nodes) columns.back()[node] = next++;
    meshes.push_back(bodies.back().input().mesh.get());
  }
  auto system = solver::make_system(std::move(bodies), std::move(turning));
  contact::SkinContactOptions options;
  options.friction = 0.4;
  system.contacts.push_back(contact::make_skin_setup(options, contact::make_side({{0, "z1"}}, meshes, columns),
                                                     contact::make_side({{1, "z0"}}, meshes, columns), 1000.0, 0.5));
  return system;
}

struct Moment {
  const solver::SolidSystem& system;
  solver::SolidState old;
  Vector force, s;

  solver::Standing standing(const Vector& a) const {
    solver::Standing at;
    at.old_poses = poses_of(system, old);
    at.x_old = positions(system, old.u);
    at.poses = poses_between(system, old, a, s);
    at.twist = relative_twists(system, at.old_poses, at.poses);
    at.x = positions(system, displacement(system, {force, s, a, at.poses}));
    return at;
  }
};

}  // namespace

TEST(SolidTurningTangent, DerivativesByFreeMotionsAreExact) {
  // Places, the motion that slip is made of, and the balance change with the free motions of both bodies as central
  // differences say, far from the start and under loads.
  const auto system = turning_blocks();
  ASSERT_EQ(system.free(), 2 + 6);
  Moment m{system, solver::initial_state(system), waves(3 * system.points(), 2.0), waves(system.driven(), 0.3)};
  m.old.a = waves(system.free(), 0.5);
  m.old.turn = {base::turn_by(Vec3(0.2, 0.7, 0)), base::turn_by(Vec3(1, -0.4, 2))};
  m.old.u = displacement(system, {m.force, m.old.s, m.old.a, poses_of(system, m.old)});
  const Vector a = m.old.a + waves(system.free(), 0.2);
  const auto at = m.standing(a);
  const auto tangent = turning_tangent(system, at, m.force, m.s, a - m.old.a);
  ASSERT_FALSE(at.twist[0].empty());
  const double h = 1e-6;
  for (int k = 0; k < system.free(); ++k) {
    const Vector d = h * Vector::Unit(system.free(), k);
    const auto ahead = m.standing(a + d), behind = m.standing(a - d);
    const Vector places = (ahead.x - behind.x) / (2 * h);
    EXPECT_LT((places - tangent.places.col(k)).norm(), 1e-8 * places.norm()) << k;
    const Vector seen = (seen_motion(system, ahead, 0) - seen_motion(system, behind, 0)) / (2 * h);
    Vector predicted = tangent.seen[0].col(k) + tangent.places.col(k);
    for (int p = system.first_point[1]; p < system.points(); ++p)  // the primary body's places count as seen, too
      predicted.segment<3>(3 * p) += at.twist[0][1].turn.cross(Vec3(tangent.places.col(k).segment<3>(3 * p)));
    EXPECT_LT((seen - predicted).norm(), 1e-8 * places.norm()) << k;
    const Vector left = (imbalance(system, {m.force, m.s, a + d, ahead.poses}) -
                         imbalance(system, {m.force, m.s, a - d, behind.poses})) /
                        (2 * h);
    EXPECT_LT((left - tangent.balance.col(k)).norm(), 1e-8 * m.force.norm()) << k;
  }
}
