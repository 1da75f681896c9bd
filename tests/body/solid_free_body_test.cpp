#include <gtest/gtest.h>

#include "body/solid_uncondensed.hpp"

namespace reye::support::solids {

namespace {

/// K u - F must vanish at all nodes but those of a face.
double residual(const SolidBody& b, const Points3& u, const Vector& f, const Vector& s, const std::string& but) {
  const auto& m = *b.input().mesh;
  Vector v(3 * m.node_count());
  for (int j = 0; j < m.node_count(); ++j) v.segment<3>(3 * j) = u[j];
  const Vector F = external(b, s) + nodal(b, f);
  Vector R = fem::stiffness(m, b.input().material) * v - F;
  if (!but.empty())
    for (int node : nodes_of_face(m, but)) R.segment<3>(3 * node).setZero();
  return R.norm() / std::max(F.norm(), 1.0);
}

// A body that nothing holds, and one that a plane or a hinge holds in part, must be in balance with any rigid motion.
TEST(solid_body, free_motions) {
  for (auto kind : support::solid_kinds)
    for (int held : {0, 1, 2}) {
      SolidInput input = input_of(kind, held == 0);
      if (kind == SolidKind::tet10) input.contact_faces = {"z1"};
      if (held == 1) input.supports = {along_normal("x0")};
      if (held == 2) input.supports = {rigid_face("x0", {fixed, fixed, moved(0.1)}, {fixed, fixed, Motion{}})};
      body::SolidLoad weight, push;
      weight.force_N_per_mm3 = Vec3(0.1, 0.5, -1);
      push.face = "y1";
      push.force_N = Vec3(1, 1, 1);
      input.loads = {weight, push};
      const SolidBody b(input, nodes_of_face(*input.mesh, "z1"));
      const auto count = b.A().cols();
      ASSERT_EQ(count, held == 0 ? 6 : held == 1 ? 3 : 1);
      const Vector s = wave(static_cast<Eigen::Index>(b.driven().size())), a = 0.01 * wave(count);
      const Vector f = balanced(b, s);
      EXPECT_LT((b.A().transpose() * f + b.B() * s).norm(), 1e-11 * f.norm());
      const Points3 u = b.displacements(f, s, a);
      EXPECT_LT(residual(b, u, f, s, held ? "x0" : ""), 1e-10);
      const Vector p = b.C().times(f) + b.U() * s + b.A() * a;
      EXPECT_LT((p - points_of(b, u)).norm(), 1e-10 * p.norm());
      if (held == 0) {
        EXPECT_EQ(b.free_motions(), (std::vector<std::string>{"rotation about x", "rotation about y",
                                                              "rotation about z", "x", "y", "z"}));
        continue;
      }
      using Names = std::vector<std::string>;
      EXPECT_EQ(b.free_motions(), held == 1 ? Names({"rotation about x", "y", "z"}) : Names({"rotation about z"}));
      expect_reactions(b, {});
      const Vector r = b.F() * f + b.G() * s;
      EXPECT_LT((r.head<6>() - reaction(b, u, f, s, 0)).norm(), 1e-9 * r.norm());
    }
}

// A rigid face that is loaded and otherwise free must be in balance with contact alone: its load is in B.
TEST(solid_body, loaded_face_of_a_free_body) {
  SolidInput input = input_of(SolidKind::hex8);
  input.supports = {rigid_face("z0", {fixed, fixed, loaded(1.0)}, {Motion{}, fixed, fixed})};
  const SolidBody b(input, nodes_of_face(*input.mesh, "z1"));
  EXPECT_EQ(b.free_motions(), (std::vector<std::string>{"rotation about x", "z"}));
  const Vector s = Vector::Constant(1, 5.0);
  const Vector f = balanced(b, s);
  double sum = 0.0;
  for (Eigen::Index k = 2; k < f.size(); k += 3) sum += f[k];
  EXPECT_NEAR(sum, -5.0, 1e-10);
  const Points3 u = b.displacements(f, s, wave(2));
  EXPECT_LT(residual(b, u, f, s, "z0"), 1e-10);
  EXPECT_LT(((b.F() * f + b.G() * s) - reaction(b, u, f, s, 0)).norm(), 1e-9);
}

}  // namespace

}  // namespace reye::support::solids
