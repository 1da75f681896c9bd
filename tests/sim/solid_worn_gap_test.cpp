#include <gtest/gtest.h>

#include <numeric>

#include "contact/solid/skin_wear.hpp"
#include "sim/solid/solid_assembly.hpp"
#include "support/solid_problem.hpp"

using namespace reye;
using base::Vec3;

namespace {

/// Two blocks on each other whose meshes do not match, the lower one secondary, as a system of equations.
sim::SolidAssembly worn_blocks(mesh::SolidKind kind) {
  auto lower = support::solid(
      "lower", support::block(kind, {3, 2, 2}, Vec3::Ones(), support::box({0, 0, 0}, {1, 1, 1})), 2e5, 0.3);
  auto upper = support::solid(
      "upper", support::block(kind, {2, 3, 2}, Vec3::Ones(), support::box({0, 0, 1}, {1, 1, 2})), 2e5, 0.3);
  for (auto* body : {&lower, &upper})
    body->supports = {support::by_node(body->name, body == &lower ? "z0" : "z1",
                                       {support::fixed_motion(), support::fixed_motion(), support::fixed_motion()})};
  auto problem = support::problem_of({lower, upper}, {0, "z1"}, {1, "z0"}, 0.3, 0.2);
  problem.contacts[0].options.wear = wear::Law{.kind = wear::LawKind::energy, .secondary = 3e-5, .primary = 2e-5};
  sim::SolidMeshes meshes;
  for (const auto& input : problem.inputs) meshes.push_back(input.mesh);
  return sim::assemble(problem, meshes, sim::touchable_nodes(problem, meshes));
}

}  // namespace

class WornGap : public testing::TestWithParam<mesh::SolidKind> {};

TEST_P(WornGap, AnEvenDepthOpensTheGapByItself) {
  // Both sides worn by an even depth open each gap by the sum of the two, and what a point takes from the primary side
  // is spread over it without loss.
  const auto assembly = worn_blocks(GetParam());
  const auto& setup = assembly.system.contacts[0];
  mortar::SkinPairs pairs;
  const auto place = contact::place_skins(setup, base::Vector::Zero(3 * assembly.system.points()), assembly.system.held,
                                          assembly.system.points(), pairs);
  const contact::SkinOpenings openings(setup, place);
  std::vector<double> secondary, primary;
  for (int j = 0; j < setup.count(); ++j) secondary.push_back(0.002 * place.area[j]);
  for (int l = 0; l < setup.primary_area.size(); ++l) primary.push_back(0.003 * setup.primary_area[l]);
  for (const double opening : openings.by_volumes(secondary, primary)) EXPECT_NEAR(opening, 0.005, 1e-15);
  std::vector<double> spread(primary.size(), 0.0);
  for (int j = 0; j < setup.count(); ++j) openings.spread(j, 1.0, spread);
  EXPECT_NEAR(std::accumulate(spread.begin(), spread.end(), 0.0), setup.count(), 1e-12);
  for (const double volume : spread) EXPECT_GE(volume, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, WornGap, testing::ValuesIn(support::solid_kinds), [](const auto& kind) {
  return std::string("kind") + std::to_string(static_cast<int>(kind.param));
});
