#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "body/solid/solid_conflicts.hpp"
#include "body/solid/solid_cost.hpp"
#include "body/solid_uncondensed.hpp"

namespace reye::support::solids {

namespace {

// A block that is fixed, by node, must move as without condensation; loads of all kinds act on it.
TEST(solid_body, fixed_with_loads) {
  for (auto kind : support::solid_kinds) {
    SolidInput input = input_of(kind, true);
    input.supports = {by_node("z0", {fixed, fixed, fixed})};
    body::SolidLoad pressure, force, weight;
    pressure.face = "x1";
    pressure.pressure_MPa = 3.0;
    pressure.traction_MPa = Vec3(0, 1, -2);
    force.face = "z1";
    force.force_N = Vec3(1, 2, 3);
    weight.force_N_per_mm3 = Vec3(0, 0.5, -1);
    input.loads = {pressure, force, weight};
    expect_reactions(expect_uncondensed(input, "z1"), {0});
  }
}

// Imposed motions along turned axes, free across them, on one face against another that is fixed.
TEST(solid_body, moved_along_turned_axes) {
  for (auto kind : support::solid_kinds) {
    SolidInput input = input_of(kind, true);
    input.supports = {by_node("x0", {fixed, moved(0.2), Motion{}}, turned), by_node("x1", {moved(0.1), fixed, fixed})};
    const SolidBody b = expect_uncondensed(input, "z1");
    EXPECT_EQ(b.driven().size(), 2u);
    expect_reactions(b, {0, 1});
  }
}

// Symmetry on planes that meet, and a third direction held on a face that meets both: nodes have one, two or three held
// directions, retained ones among them.
TEST(solid_body, symmetry_on_planes_that_meet) {
  for (auto kind : support::solid_kinds) {
    SolidInput input = input_of(kind);
    input.supports = {along_normal("x0"), along_normal("y0"), along_normal("z0", moved(0.05))};
    const SolidBody b = expect_uncondensed(input, "z1");
    const Vector f = wave(b.C().rows()), s = Vector::Constant(1, 0.4);
    const Vector r = b.F() * f + b.G() * s;
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      sum += r.segment<3>(6 * k);
      Vec3 across = r.segment<3>(6 * k);
      across[k] = 0.0;
      EXPECT_LT(across.norm(), 1e-12 * r.norm()) << "a plane of symmetry takes no shear";
    }
    for (Eigen::Index k = 0; k < f.size(); ++k) sum[k % 3] += f[k];
    EXPECT_LT(sum.norm(), 1e-10 * r.norm());
  }
}

// The factor of a body in another shape, or of quite another body, changes nothing but the work: the compliance and the
// displacements are those of a fresh body to the last bit.
TEST(solid_body, spare_factor_leaves_no_trace) {
  for (auto kind : support::solid_kinds) {
    const auto made = [&](bool curved, const std::string& face, std::optional<algebra::SchurFactor> spare) {
      SolidInput input = input_of(kind, curved);
      input.supports = {by_node("z0", {fixed, fixed, moved(0.1)})};
      return SolidBody(input, nodes_of_face(*input.mesh, face), std::move(spare));
    };
    const SolidBody fresh = made(true, "z1", {});
    for (const std::string of : {"z1", "x1"}) {  // retains nodes as here, and others
      SolidBody before = made(false, of, {});
      const SolidBody again = made(true, "z1", before.take_factor());
      EXPECT_EQ(again.C().dense(), fresh.C().dense()) << of;
      const Vector f = wave(fresh.C().rows()), s = Vector::Constant(1, 0.4);
      EXPECT_EQ(again.displacements(f, s, Vector()), fresh.displacements(f, s, Vector())) << of;
    }
  }
}

// Held directions of a node that are neither parallel nor orthogonal must all be kept, with their values.
TEST(solid_body, oblique_directions_in_one_node) {
  for (auto kind : support::solid_kinds) {
    SolidInput input = input_of(kind);
    const Mat3 oblique = Eigen::AngleAxisd(0.4, Vec3(1, 1, 1).normalized()).toRotationMatrix();
    input.supports = {by_node("x0", {moved(0.1), fixed, Motion{}}),
                      by_node("z0", {moved(-0.3), Motion{}, fixed}, oblique)};
    // Along the common edge four directions are asked for, of which three can be had.
    EXPECT_FALSE(body::solid_support_conflicts(input).empty());
    input.supports[1].along[0] = Motion{};
    input.supports[1].along[2] = moved(0.2);
    EXPECT_TRUE(body::solid_support_conflicts(input).empty());
    input.supports.push_back(by_node("x1", {Motion{}, fixed, Motion{}}));
    const SolidBody b = expect_uncondensed(input, "z1");
    const Vector f = wave(b.C().rows()), s = 0.1 * wave(2);
    const Vector r = b.F() * f + b.G() * s;
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) sum += r.segment<3>(6 * k);
    for (Eigen::Index k = 0; k < f.size(); ++k) sum[k % 3] += f[k];
    EXPECT_LT(sum.norm(), 1e-10 * r.norm());
  }
}

// A rigid face, its motions along turned axes moved, loaded, loaded against a spring and free.
TEST(solid_body, rigid_face_with_every_drive) {
  for (auto kind : support::solid_kinds) {
    SolidInput input = input_of(kind, true);
    input.supports = {
        by_node("z0", {fixed, fixed, fixed}),
        rigid_face("x1", {moved(0.1), loaded(2.0), loaded(1.0, 40.0)}, {Motion{}, loaded(0.5), moved(0.02)}, turned)};
    input.supports[0].face = "x0";
    const SolidBody b = expect_uncondensed(input, "z1");
    expect_reactions(b, {0, 1});
    const Vector f = Vector::Zero(b.C().rows());
    Vector s = Vector::Zero(static_cast<Eigen::Index>(b.driven().size()));
    for (size_t k = 0; k < b.driven().size(); ++k)
      if (b.driven()[k].support == 1 && b.driven()[k].motion == 1) s[static_cast<Eigen::Index>(k)] = 7.0;
    const Vector r = b.G() * s;
    EXPECT_NEAR(turned.col(1).dot(r.segment<3>(6)), 7.0, 1e-10) << "a loaded motion without a spring takes its load";
  }
}

// Mid nodes of contact faces must be exchanged for control points: forces and displacements are those of Bernstein
// functions, where nothing holds them, at the rim of a plane of symmetry, and on a rigid face's edge.
TEST(solid_body, control_points) {
  for (bool curved : {false, true}) {
    SolidInput input = input_of(SolidKind::tet10, curved);
    input.contact_faces = {"z1"};
    input.supports = {by_node("z0", {fixed, fixed, fixed})};
    expect_reactions(expect_uncondensed(input, "z1"), {0});
    input.supports = {along_normal("x0"), rigid_face("x1", {fixed, moved(0.1), fixed}, {moved(0.1), fixed, fixed})};
    expect_uncondensed(input, "z1");
  }
}

// Retained nodes that cannot show a free motion must be refused, and a body without any be a SolveError, not a NaN.
TEST(solid_body, too_few_retained_nodes) {
  SolidInput input = input_of(SolidKind::hex8);
  EXPECT_THROW(SolidBody(input, {0, 1}), base::SolveError);
  EXPECT_THROW(SolidBody(input, {}), base::SolveError);
  input.supports = {by_node("z0", {fixed, fixed, fixed})};
  const SolidBody b(input, {});
  EXPECT_EQ(b.C().rows(), 0);
  EXPECT_EQ(largest(b.displacements(Vector(), Vector(), Vector())), 0.0);
}

// A body made twice must be the same bit for bit.
TEST(solid_body, repeats_bit_by_bit) {
  SolidInput input = input_of(SolidKind::tet10, true);
  input.supports = {by_node("x0", {fixed, moved(0.2), Motion{}}, turned)};
  const SolidBody first(input, nodes_of_face(*input.mesh, "z1")), second(input, nodes_of_face(*input.mesh, "z1"));
  EXPECT_EQ((first.C().dense() - second.C().dense()).norm(), 0.0);
  EXPECT_EQ((first.F() - second.F()).norm(), 0.0);
}

// Retained nodes in any order, held ones and nodes of a rigid face among them, must give their own rows.
TEST(solid_body, any_retained_nodes) {
  SolidInput input = input_of(SolidKind::hex8, true);
  input.supports = {by_node("x0", {fixed, moved(0.2), Motion{}}, turned),
                    rigid_face("x1", {moved(0.1), loaded(1.0), fixed}, {fixed, fixed, fixed})};
  std::vector<int> all;
  for (int k = 0; k < input.mesh->node_count(); ++k) all.push_back((k * 7 + 3) % input.mesh->node_count());
  const SolidBody whole(input, all), some(input, {5, 13, 0, 26});
  const Vector f = wave(12), s = wave(3);
  Vector spread = Vector::Zero(whole.C().rows());
  for (int k = 0; k < 4; ++k)
    for (size_t j = 0; j < all.size(); ++j)
      if (all[j] == some.retained()[k]) spread.segment<3>(3 * static_cast<Eigen::Index>(j)) = f.segment<3>(3 * k);
  const Points3 u = some.displacements(f, s, Vector());
  EXPECT_LT(difference(whole.displacements(spread, s, Vector()), u), 1e-10);
  EXPECT_LT((whole.C().times(spread) + whole.U() * s - points_of(whole, u)).norm(), 1e-10);
  EXPECT_LT((some.C().times(f) + some.U() * s - points_of(some, u)).norm(), 1e-10);
  EXPECT_LT((whole.F() * spread + whole.G() * s - some.F() * f - some.G() * s).norm(), 1e-9 * (some.F() * f).norm());
}

// The cost of a body must grow with it and with what is retained; a rigid one has no factor.
TEST(solid_cost, grows) {
  const auto cost = [](int n, size_t retained) {
    const auto m = block(SolidKind::hex8, {n, n, n}, Vec3(1, 1, 1));
    auto top = nodes_of_face(m, "z1");
    top.resize(retained);
    return body::solid_cost(m, top);
  };
  const auto small = cost(6, 4), wide = cost(6, 49), large = cost(12, 49);
  EXPECT_GT(wide.factor_entries, small.factor_entries);
  EXPECT_GT(large.seconds, 8.0 * wide.seconds);
  EXPECT_GT(large.memory_MB, large.factor_entries * 8e-6);
  auto skin = *rigid_input().mesh;
  EXPECT_EQ(body::solid_cost(skin, {1, 2}).factor_entries, 0.0);
}

}  // namespace

}  // namespace reye::support::solids
