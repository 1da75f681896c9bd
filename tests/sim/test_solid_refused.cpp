#include <gtest/gtest.h>

#include "sim/solid/refused_contacts.hpp"
#include "support/solid_hertz.hpp"

using namespace reye;
using base::Vec3;

namespace {

sim::SolidProblem wearing_ball(mesh::SolidKind kind) {
  support::HertzCase c;
  c.kind = kind;
  c.elements = 1.0;
  auto problem = support::hertz_problem(c);
  problem.contacts[0].options.wear = {.kind = wear::LawKind::archard, .secondary = 1e-8, .primary = 1e-8};
  return problem;
}

std::vector<std::string> keys(const sim::SolidProblem& problem) {
  std::vector<std::string> keys;
  for (const auto& issue : sim::refused_contacts(problem.inputs, problem.contacts, problem.scene.symmetry))
    keys.push_back(issue.key);
  return keys;
}

using Keys = std::vector<std::string>;

}  // namespace

// The linear dual basis must be refused where facets of second order wear, and there alone.
TEST(SolidRefused, LinearBasisOfFacetsThatWear) {
  for (const auto kind : {mesh::SolidKind::tet10, mesh::SolidKind::tet4}) {
    auto problem = wearing_ball(kind);
    problem.contacts[0].options.dual = mortar::SkinDual::linear;
    EXPECT_EQ(keys(problem), kind == mesh::SolidKind::tet10 ? Keys{"contact.pad.dual"} : Keys{});
    problem.contacts[0].options.wear = {};
    EXPECT_EQ(keys(problem), Keys{});
  }
}

// A face that two contacts wear must be refused; one that the second contact leaves whole must not.
TEST(SolidRefused, FaceThatTwoContactsWear) {
  auto problem = wearing_ball(mesh::SolidKind::hex8);
  problem.contacts.push_back(problem.contacts[0]);
  problem.contacts[1].options.name = "other";
  problem.contacts[1].secondary.face = "far";
  EXPECT_EQ(keys(problem), Keys{"contact.other.wear"});
  problem.contacts[1].options.wear.primary = 0.0;
  EXPECT_EQ(keys(problem), Keys{});
}

// Sliding across a plane of symmetry must be refused with friction: a mirror turns it round. Along the planes, and
// about an axis normal to the plane, the mirror agrees.
TEST(SolidRefused, SlidingAcrossAPlaneOfSymmetry) {
  auto problem = wearing_ball(mesh::SolidKind::hex8);
  auto& options = problem.contacts[0].options;
  problem.scene.symmetry = {"y0"};
  const auto with = [&](double friction, const contact::ImposedSliding& sliding) {
    options.friction = friction;
    options.sliding = {sliding};
    return keys(problem);
  };
  EXPECT_EQ(with(0.5, {.direction = Vec3::UnitX()}), Keys{});
  EXPECT_EQ(with(0.5, {.axis = Vec3::UnitY()}), Keys{});
  EXPECT_EQ(with(0.0, {.direction = Vec3::UnitY()}), Keys{});
  EXPECT_EQ(with(0.5, {.direction = Vec3(1.0, 1.0, 0.0)}), Keys{"contact.pad.imposed_sliding_mm"});
  EXPECT_EQ(with(0.5, {.axis = Vec3::UnitZ()}), Keys{"contact.pad.imposed_turn_rad"});
}
