#include <gtest/gtest.h>

#include "body/solid/solid_turning.hpp"
#include "body/solid_inputs.hpp"

namespace reye::support::solids {

namespace {

SolidInput free_block(bool rigid = false) {
  SolidInput input = input_of(SolidKind::hex8, true);
  input.rigid = rigid;
  input.contact_faces = {"z1"};
  return input;
}

SolidInput holder(std::array<Motion, 3> along, std::array<Motion, 3> about) {
  SolidInput input = free_block();
  input.supports = {rigid_face("z0", along, about)};
  return input;
}

}  // namespace

// A body turns where contact alone guides it or one rigid support leaves or drives a rotation, and not where its
// rotations are fixed.
TEST(solid_turning, which_bodies_turn) {
  EXPECT_EQ(solid_pivot(free_block())->support, -1);
  EXPECT_TRUE(solid_pivot(free_block(true)));
  EXPECT_TRUE(solid_pivot(holder({fixed, fixed, loaded(1.0)}, {fixed, fixed, moved(6.0)})));
  EXPECT_FALSE(solid_pivot(holder({fixed, moved(1.0), loaded(1.0)}, {fixed, fixed, fixed})));
  EXPECT_FALSE(solid_pivot(holder({fixed, fixed, fixed}, {fixed, fixed, moved(0.0)})));
  SolidInput clamped = free_block();
  clamped.supports = {by_node("z0", {fixed, fixed, fixed})};
  EXPECT_FALSE(solid_pivot(clamped));
  EXPECT_EQ(body::solid_keeps_direction(clamped), "");
}

// Planes of symmetry go with a turn about their normal, and with no other.
TEST(solid_turning, planes_beside_a_pivot) {
  SolidInput input = holder({fixed, fixed, fixed}, {fixed, fixed, moved(6.0)});
  input.supports.push_back(along_normal("x0"));
  EXPECT_FALSE(solid_pivot(input));
  EXPECT_EQ(body::solid_keeps_direction(input), "x0");
  input = holder({fixed, fixed, loaded(1.0)}, {moved(6.0), fixed, fixed});
  input.supports.push_back(along_normal("x0"));
  EXPECT_TRUE(solid_pivot(input));
  input.supports[0].along[0] = loaded(1.0);
  EXPECT_FALSE(solid_pivot(input)) << "the plane would be left";
  SolidInput alone = free_block();
  alone.supports = {along_normal("x0")};
  ASSERT_TRUE(solid_pivot(alone));
  const auto turning = make_turning(alone, *solid_pivot(alone), {0});
  EXPECT_EQ(turning.count(), 3);
  EXPECT_NEAR(std::abs(turning.axis(2).x()), 1.0, 1e-12);
}

// A second bearing goes with a turn about its axis, and not with one beside it; nor does a support that holds one of
// the directions across alone.
TEST(solid_turning, bearings_beside_a_pivot) {
  const auto shaft = [](const Vec3& off, const Motion& across) {
    SolidInput input = holder({fixed, fixed, fixed}, {fixed, fixed, moved(6.0)});
    input.supports.insert(input.supports.begin(),
                          rigid_face("z1", {fixed, across, Motion{}}, {Motion{}, Motion{}, Motion{}}));
    input.supports[0].centre_mm = Vec3(0.5, 0.6, 0.8) + off;
    return input;
  };
  const auto pivot = solid_pivot(shaft(Vec3::Zero(), fixed));
  ASSERT_TRUE(pivot);
  EXPECT_EQ(pivot->support, 1);
  EXPECT_FALSE(solid_pivot(shaft(Vec3(0.1, 0, 0), fixed)));
  EXPECT_FALSE(solid_pivot(shaft(Vec3::Zero(), Motion{})));
  EXPECT_EQ(body::solid_keeps_direction(shaft(Vec3(0.1, 0, 0), fixed)), "z1");
}

// Two supports that leave a rotation free keep the body's direction, by name.
TEST(solid_turning, names_what_keeps_the_direction) {
  SolidInput input = holder({fixed, fixed, fixed}, {fixed, fixed, Motion{}});
  input.supports.push_back(rigid_face("z1", {fixed, fixed, Motion{}}, {Motion{}, fixed, Motion{}}));
  input.supports[1].centre_mm = Vec3(0.5, 0.6, 0.8);
  EXPECT_FALSE(solid_pivot(input));
  EXPECT_EQ(body::solid_keeps_direction(input), "z1");
}

namespace {

struct TurnedBody {
  SolidInput input;
  body::SolidTurning turning;
  body::SolidBody frame;
  Vector s, a;

  explicit TurnedBody(const SolidInput& given)
      : input(given),
        turning(make_turning(given, *solid_pivot(given), nodes_of_face(*given.mesh, "z1"))),
        frame(in_frame(given, *solid_pivot(given)), nodes_of_face(*given.mesh, "z1")),
        s(wave(static_cast<Eigen::Index>(turning.driven.size()))),
        a(0.7 * wave(turning.count())) {}
};

SolidInput loaded_holder() {
  SolidInput input = holder({fixed, moved(0.3), loaded(2.0, 5.0)}, {loaded(1.0), Motion{}, moved(2.0)});
  input.supports[0].axes = turned;
  body::SolidLoad weight, push;
  weight.force_N_per_mm3 = Vec3(0.1, 0.5, -1);
  push.face = "y1";
  push.force_N = Vec3(1, 1, 1);
  push.pressure_MPa = 0.7;
  push.traction_MPa = Vec3(0.3, -0.2, 0.1);
  input.loads = {weight, push};
  return input;
}

}  // namespace

// Forces on a body that is turned far, its loads and what its pivot takes, must be in balance, and so their moments.
TEST(solid_turning, forces_and_moments_balance) {
  for (const bool rigid : {false, true}) {
    SolidInput input = loaded_holder();
    input.rigid = rigid;
    const TurnedBody b(input);
    const auto pose = pose_of(b.turning, base::turn_by(Vec3(1, -2, 0.5)), 0.2 * b.a, b.a, b.s);
    const Vector f = wave(b.frame.C().rows());
    const body::Mode r =
        to_space(pose, b.frame.F() * to_frame(pose, f) + b.frame.G() * frame_values(b.turning, pose, b.s));
    body::Mode sum = r + load_wrench(b.turning, pose, b.s);
    for (std::size_t i = 0; i < b.turning.points.size(); ++i) {
      const Vec3 force = f.segment<3>(3 * static_cast<Eigen::Index>(i));
      sum.head<3>() += force;
      sum.tail<3>() += (pose.place(b.turning.points[i], Vec3::Zero()) - pose.pivot()).cross(force);
    }
    EXPECT_LT(sum.norm(), 1e-11 * r.norm());
    const Vector left = balance_of(b.turning, pose, f, b.a, b.s);
    for (int k = 0; k < b.turning.count(); ++k) {  // what the pivot takes there is its load less its spring
      const int v = b.turning.value[b.turning.free[k]];
      const double given = (v < 0 ? 0.0 : b.s[v]) - b.turning.stiffness(k) * b.a[k];
      EXPECT_NEAR(left[k], given - b.turning.axis(k).dot(r.segment<3>(b.turning.rotation(k) ? 3 : 0)),
                  1e-11 * r.norm());
    }
  }
}

// A load keeps its direction in space while the body turns, a pressure follows the face.
TEST(solid_turning, loads_in_space_and_on_the_body) {
  SolidInput input = loaded_holder();
  const TurnedBody b(input);
  const auto pose = pose_of(b.turning, base::turn_by(Vec3(1, -2, 0.5)), 0.2 * b.a, b.a, b.s);
  const double area = mesh::area(input.mesh->X, mesh::facets_of(*input.mesh, "y1"));
  Vec3 pressed = Vec3::Zero();
  for (const auto& facet : mesh::facets_of(*input.mesh, "y1")) pressed -= 0.7 * mesh::area_vector(input.mesh->X, facet);
  const Vec3 dead = input.loads[1].force_N + area * input.loads[1].traction_MPa;
  const Vec3 weight = mesh::volume(*input.mesh) * input.loads[0].force_N_per_mm3;
  const auto factor = [&](int load) {
    for (std::size_t k = 0; k < b.turning.driven.size(); ++k)
      if (b.turning.driven[k].load == load) return b.s[static_cast<Eigen::Index>(k)];
    return 0.0;
  };
  const Vec3 expected = factor(0) * weight + factor(1) * (dead + pose.R * pressed);
  EXPECT_LT((load_wrench(b.turning, pose, b.s).head<3>() - expected).norm(), 1e-12 * expected.norm());
}

// The balance changes with the unknown motions as its derivative says.
TEST(solid_turning, balance_rate_is_the_derivative) {
  const TurnedBody b(loaded_holder());
  const base::Turn before = base::turn_by(Vec3(1, -2, 0.5));
  const Vector f = wave(b.frame.C().rows()), step = 0.2 * b.a;
  const auto pose_after = [&](const Vector& more) { return pose_of(b.turning, before, step + more, b.a + more, b.s); };
  const Matrix rate = balance_rate(b.turning, pose_after(0.0 * b.a), f, step, b.s);
  const double h = 1e-6;
  for (int k = 0; k < b.turning.count(); ++k) {
    const Vector d = h * Vector::Unit(b.turning.count(), k);
    const Vector slope = (balance_of(b.turning, pose_after(d), f, b.a + d, b.s) -
                          balance_of(b.turning, pose_after(-d), f, b.a - d, b.s)) /
                         (2.0 * h);
    EXPECT_LT((slope - rate.col(k)).norm(), 1e-8 * rate.norm());
  }
}

// A body that is not yet turned must be condensed as by the linear theory: the same displacements under small motions.
TEST(solid_turning, small_turns_are_those_of_the_linear_body) {
  SolidInput input = holder({fixed, moved(1.0), fixed}, {fixed, fixed, moved(1.0)});
  const TurnedBody b(input);
  const body::SolidBody linear(input, nodes_of_face(*input.mesh, "z1"));
  const double small = 1e-6;
  const Vector s = small * wave(2), f = small * wave(b.frame.C().rows());
  const auto pose = pose_of(b.turning, base::Turn::Identity(), Vector(), Vector(), s);
  const Vector w = b.frame.C().times(to_frame(pose, f)), u = linear.C().times(f) + linear.U() * s;
  for (std::size_t i = 0; i < b.turning.points.size(); ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(i);
    const Vec3 moved = pose.place(b.turning.points[i], w.segment<3>(at)) - b.turning.points[i];
    EXPECT_LT((moved - u.segment<3>(at)).norm(), 1e-5 * small);
  }
}

}  // namespace reye::support::solids
