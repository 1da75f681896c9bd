#include <gtest/gtest.h>

#include "body/solid_uncondensed.hpp"

namespace reye::support::solids {

namespace {

/// Sum of forces and moments about c of all that acts on a rigid body: contact, loads, supports.
Eigen::Matrix<double, 6, 1> all_forces(const SolidBody& b, const Vector& f, const Vector& s, const Vec3& c) {
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  const auto add = [&](const Vec3& force, const Vec3& at) {
    sum.head<3>() += force;
    sum.tail<3>() += (at - c).cross(force);
  };
  const Vector F = nodal(b, f);
  for (int k = 0; k < b.input().mesh->node_count(); ++k) add(F.segment<3>(3 * k), b.input().mesh->X[k]);
  for (size_t k = 0; k < b.driven().size(); ++k) {
    if (b.driven()[k].load < 0) continue;
    const auto& load = b.input().loads[b.driven()[k].load];
    const double factor = s[static_cast<Eigen::Index>(k)];
    if (load.face.empty()) {
      add(factor * mesh::volume(*b.input().mesh) * load.force_N_per_mm3, mesh::volume_centroid(*b.input().mesh));
    } else {
      const auto facets = mesh::facets_of(*b.input().mesh, load.face);
      add(factor * load.force_N, mesh::area_centroid(b.input().mesh->X, facets));
    }
  }
  const Vector r = b.F() * f + b.G() * s;
  for (int k = 0; k < static_cast<int>(b.input().supports.size()); ++k) {
    add(r.segment<3>(6 * k), centre_of(b.input(), k));
    sum.tail<3>() += r.segment<3>(6 * k + 3);
  }
  return sum;
}

// A rigid body must move rigidly as its supports say, its resultants balance all that acts on it, and what nothing
// holds be free.
TEST(solid_rigid_body, moves_and_balances) {
  SolidInput input = rigid_input();
  SolidSupport push = rigid_face("", {fixed, moved(0.1), loaded(-5.0)}, {fixed, moved(0.03), fixed}, turned);
  push.body = "block";
  push.centre_mm = Vec3(0.3, -1.0, 2.0);
  body::SolidLoad weight, force;
  weight.force_N_per_mm3 = Vec3(0.1, 0, -1);
  force.face = "x1";
  force.force_N = Vec3(1, -2, 0.5);
  input.supports = {push};
  input.loads = {weight, force};
  const SolidBody b(input, nodes_of_face(*input.mesh, "z1"));
  EXPECT_EQ(b.C().dense().norm(), 0.0);
  ASSERT_EQ(b.A().cols(), 1);
  const Vector s = wave(5), f = balanced(b, s), a = Vector::Constant(1, 0.2);
  const auto sum = all_forces(b, f, s, Vec3(1, 2, 3));
  EXPECT_LT(sum.norm(), 1e-11 * f.norm());
  const Points3 u = b.displacements(f, s, a);
  EXPECT_LT((b.U() * s + b.A() * a - points_of(b, u)).norm(), 1e-12);
  const double moved_by = s[0];
  for (int k : {0, 7, 30}) {
    const Vec3 turn = turned.col(1) * s[2];
    const Vec3 rest = u[k] - turned.col(1) * moved_by - turn.cross(input.mesh->X[k] - *push.centre_mm);
    EXPECT_LT(rest.cross(Vec3(turned.col(2))).norm(), 1e-12) << "all else is along the loaded axis";
  }
}

// A rigid body on faces held node by node: what follows from them is held, too, whatever the number of nodes.
TEST(solid_rigid_body, held_by_its_faces) {
  SolidInput input = rigid_input();
  input.mesh = [] {
    auto m = block(SolidKind::tet4, {2, 2, 2}, Vec3(1, 1.2, 0.8));
    m.cells.clear();
    return std::make_shared<mesh::SolidMesh>(m);
  }();
  input.supports = {along_normal("z0", moved(0.1)), along_normal("x0")};
  const SolidBody b(input, nodes_of_face(*input.mesh, "z1"));
  EXPECT_EQ(b.free_motions(), (std::vector<std::string>{"y"}));
  const Vector s = Vector::Constant(1, 0.3), f = balanced(b, s);
  EXPECT_LT(all_forces(b, f, s, Vec3(1, 2, 3)).norm(), 1e-11 * f.norm());
  for (const Vec3& u : b.displacements(f, s, Vector::Constant(1, 0.5)))
    EXPECT_LT((u - Vec3(0, 0.5, -0.3)).norm(), 1e-12);
}

// A rigid body on springs must be as compliant as they are: load over stiffness, moments about the centre included.
TEST(solid_rigid_body, on_springs) {
  SolidInput input = rigid_input();
  SolidSupport spring = rigid_face("", {fixed, fixed, loaded(2.0, 50.0)}, {loaded(0.0, 8.0), fixed, fixed});
  spring.centre_mm = Vec3(0.5, 0.6, 0.4);
  input.supports = {spring};
  const SolidBody b(input, nodes_of_face(*input.mesh, "z1"));
  EXPECT_EQ(b.A().cols(), 0);
  Vector s(2), f = Vector::Zero(b.C().rows());
  s << 3.0, 0.4;
  f[2] = 1.5;  // along z at the first node
  const int first = b.retained()[0];
  const Points3 points = mesh::control_points(control_facets(input), input.mesh->X);
  const double arm = points[first].y() - 0.6;
  const Points3 u = b.displacements(f, s, Vector());
  const double z = (3.0 + 1.5) / 50.0, turn = (0.4 + 1.5 * arm) / 8.0;
  EXPECT_NEAR(u[first].z(), z + turn * (input.mesh->X[first].y() - 0.6), 1e-12);
  EXPECT_LT((b.C().times(f) + b.U() * s - points_of(b, u)).norm(), 1e-13);
  EXPECT_LT(all_forces(b, f, s, Vec3(1, 2, 3)).norm(), 1e-11);
  EXPECT_NEAR((b.F() * f + b.G() * s)[2], 3.0 - 50.0 * z, 1e-12);
}

}  // namespace

}  // namespace reye::support::solids
