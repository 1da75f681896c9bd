#include <gtest/gtest.h>

#include <algorithm>

#include "contact/fields.hpp"
#include "sim/played.hpp"
#include "sim/problem/system.hpp"
#include "sim/problem_of.hpp"
#include "sim/reshape/carry.hpp"

using namespace reye;

namespace {

using contact::OnFreshMesh;
using contact::Site;
using test::sum;

/// Two meshes of the same blocks.
struct Remeshed {
  sim::Problem coarse = test::problem_of(test::block_scene);
  sim::Problem fine = test::problem_of(test::with(
      test::block_scene, {{"far_size_mm = 0.5", "far_size_mm = 0.3"}, {"far_size_mm = 0.4", "far_size_mm = 0.25"}}));
  sim::Cache cache, fine_cache;
  contact::Setup from = sim::system_of(coarse, sim::initial_state(coarse), cache)->contacts[0];
  contact::Setup to = sim::system_of(fine, sim::initial_state(fine), fine_cache)->contacts[0];
  contact::ContactState state = contact::fresh_state(from);
  sim::HeldTraction held{std::vector<double>(from.secondary.X.size(), 2.0),
                         std::vector<double>(from.secondary.X.size(), 0.5)};

  void carry() {
    sim::carry_contact(coarse.contacts[0], coarse.scene.analysis, coarse.shapes, fine.shapes, state, held);
  }
};

}  // namespace

// Over a remesh every quantity of a contact must do what its entry in the list says: keep its sum, stay within the
// values that it had, stay a direction, or start afresh; and have a value at every node of its side.
TEST(Carry, EveryFieldAsItsEntrySays) {
  Remeshed r;
  contact::for_each_field(r.state, [&](const contact::Field& field, auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    const auto& X = field.site == Site::secondary ? r.from.secondary.X : r.from.primary.X;
    if constexpr (std::same_as<Member, double>)
      member = 7.0;
    else if constexpr (std::same_as<Member, std::vector<double>>)
      for (member.resize(X.size()); const auto& x : X) member[&x - X.data()] = 1.0 + x.x();
    else if constexpr (std::same_as<Member, std::vector<contact::Vec2>>)
      std::fill(member.begin(), member.end(), contact::Vec2(0.6, -0.8));
    else if constexpr (std::same_as<Member, std::vector<contact::ContactStatus>>)
      std::fill(member.begin(), member.end(), contact::ContactStatus::stick);
  });
  contact::ContactState before = r.state;
  r.carry();
  contact::for_each_field(before, r.state, [&](const contact::Field& field, const auto& was, const auto& is) {
    SCOPED_TRACE(field.name);
    using Member = std::remove_cvref_t<decltype(is)>;
    if constexpr (std::same_as<Member, double>) {
      EXPECT_EQ(is, was);
    } else {
      EXPECT_EQ(is.size(), (field.site == Site::secondary ? r.to.secondary.X : r.to.primary.X).size() *
                               (field.optional && field.on_fresh_mesh == OnFreshMesh::derived ? 0 : 1));
      EXPECT_NE(is.size(), was.size());
    }
    if constexpr (std::same_as<Member, std::vector<double>>) {
      if (field.on_fresh_mesh == OnFreshMesh::summed) {
        EXPECT_NEAR(sum(is), sum(was), 1e-12 * sum(was));
      } else if (field.on_fresh_mesh == OnFreshMesh::derived) {
        EXPECT_EQ(sum(is), 0.0);
      } else {
        const auto [low, high] = std::minmax_element(was.begin(), was.end());
        EXPECT_GE(*std::min_element(is.begin(), is.end()), *low - 1e-12);
        EXPECT_LE(*std::max_element(is.begin(), is.end()), *high + 1e-12);
      }
    } else if constexpr (std::same_as<Member, std::vector<contact::Vec2>>) {
      if (field.on_fresh_mesh == OnFreshMesh::direction) {
        for (const auto& v : is) EXPECT_LT((v - contact::Vec2(0.6, -0.8)).norm(), 1e-12);
      }
    } else if constexpr (std::same_as<Member, std::vector<contact::ContactStatus>>) {
      for (const auto s : is) EXPECT_EQ(s, contact::ContactStatus::stick);
    }
  });
}

// The multipliers on a fresh mesh must be the held forces, node by node.
TEST(Carry, TractionsFollowFromHeldForces) {
  Remeshed r;
  std::fill(r.state.normal.begin(), r.state.normal.end(), contact::Vec2(0.0, -1.0));
  std::fill(r.state.status.begin(), r.state.status.end(), contact::ContactStatus::slip);
  const double force = sum(r.held.normal), shear = sum(r.held.tangential);
  r.carry();
  double pressed = 0.0, dragged = 0.0;
  for (std::size_t k = 0; k < r.state.lambda.size(); ++k) {
    pressed -= r.state.lambda[k].y() * r.to.secondary.area[k];
    dragged += r.state.lambda[k].x() * r.to.secondary.area[k];
  }
  EXPECT_NEAR(pressed, force, 1e-12 * force);
  EXPECT_NEAR(dragged, shear, 1e-12 * shear);
}
