#include "sim/march/stick_edge.hpp"

#include <algorithm>

#include "verification/wear_scene.hpp"

/// Elements at the edge of a stick zone: what a scene that leaves them open gets, and what one that gets others hears.
namespace reye::verification {

namespace {

/// geo/partial_slip_life, coarse, over two blocks.
Played coarse(Replacements words) {
  words.insert(words.begin(), {{"size_mm = 0.0045", "size_mm = 0.012"},
                               {"half_width_mm = 0.13, depth_mm = 0.1", "half_width_mm = 0.12, depth_mm = 0.05"},
                               {"far_size_mm = 0.8", "far_size_mm = 2.0"},
                               {"increments = 10", "increments = 4"},
                               {"increments = 40", "increments = 8"},
                               {"cycles = 1000\njump = { tolerance = 0.01 }", "cycles = 20\njump = 10"},
                               {"cycles = 9000\njump = { tolerance = 0.01 }", "cycles = 10\njump = 10"}});
  return played(scene_text("partial_slip_life", words));
}

const sim::Warning* stick_warning(const Played& run) {
  const auto& all = run.summary.warnings;
  const auto found = std::find_if(all.begin(), all.end(), [](const sim::Warning& w) {
    return w.kind == "stick_edge" && w.text.find("stick zone recedes") != std::string::npos;
  });
  return found == all.end() ? nullptr : &*found;
}

const std::pair<std::string, std::string> first_order{"material = \"steel\"\nmesh",
                                                      "material = \"steel\"\norder = 1\nmesh"};

Replacements moved(const std::string& mm) {
  return {{"x        = { force_N_per_mm = 36.0", "x        = { motion_mm = " + mm}};
}

}  // namespace

// A contact that only forces drive must get second order and linear multipliers where the scene leaves them open; the
// plan must say so, and the run has nothing to warn of.
TEST(StickEdge, SecondOrderWhereForcesDrive) {
  const auto run = coarse({});
  for (const auto& shape : run.problem.shapes) EXPECT_EQ(shape->mesh.kind, mesh::CellKind::quad8);
  EXPECT_EQ(run.problem.contacts.at(0).options.dual, contact::DualOrder::linear);
  const auto& lines = run.problem.plan.lines;
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("contact pad: only forces drive it") &&
           line.find("second order for cylinder, flat and linear multipliers") != std::string::npos;
  }));
  EXPECT_EQ(stick_warning(run), nullptr);
}

// On elements of first order a run must warn of a stick zone that stays through a block in which the rest wears,
// whether the scene asked for them or the contact's body is moved by a given way.
TEST(StickEdge, FirstOrderIsWarnedOf) {
  const auto asked = coarse({first_order});
  for (const auto& shape : asked.problem.shapes) EXPECT_EQ(shape->mesh.kind, mesh::CellKind::quad4);
  ASSERT_NE(stick_warning(asked), nullptr);
  EXPECT_EQ(stick_warning(asked)->about, "contact pad");
  const auto slightly = coarse(moved("0.0006"));
  for (const auto& shape : slightly.problem.shapes) EXPECT_EQ(shape->mesh.kind, mesh::CellKind::quad4);
  EXPECT_NE(stick_warning(slightly), nullptr);
}

// A contact that slides as a whole must keep first order, and its run must not warn of a stick zone.
TEST(StickEdge, GrossSlidingStaysAsItIs) {
  const auto run = coarse(moved("0.02"));
  for (const auto& shape : run.problem.shapes) EXPECT_EQ(shape->mesh.kind, mesh::CellKind::quad4);
  EXPECT_EQ(stick_warning(run), nullptr);
}

// The estimate must be that of the punches: at Q = mu P / 2 the edge goes from 0.707 to 0.66 a; a stick zone that the
// ratio leaves nothing of vanishes.
TEST(StickEdge, Estimate) {
  EXPECT_NEAR(sim::receded(std::sqrt(0.5)), std::sqrt(1.0 - 0.5 * 1.13), 1e-12);
  EXPECT_EQ(sim::receded(0.3), 0.0);
}

// A stick zone that forces alone drive keeps its width: a run that loses it must say so.
TEST(StickEdge, RecedingZoneIsWarnedOf) {
  const auto lost = [](const Played& run) {
    const auto& all = run.summary.warnings;
    return std::any_of(all.begin(), all.end(), [](const sim::Warning& w) { return w.kind == "stick_zone"; });
  };
  EXPECT_FALSE(lost(coarse({})));
  // Not remeshed: fresh facets, other ones at the edge, hold it or lose it by chance.
  EXPECT_TRUE(lost(coarse({first_order,
                           {"size_mm = 0.012", "size_mm = 0.009"},
                           {"force_N_per_mm = 36.0", "force_N_per_mm = 66.0"},
                           {"cycles = 20\njump = 10", "cycles = 4000\njump = 200"},
                           {"[output]", "[remesh]\nautomatic = false\n\n[output]"}})));
}

// An edge is known to one element: a run whose depth hangs on it must say so, and not on the mesh of the scene.
TEST(StickEdge, FewElementsAreWarnedOf) {
  const auto told = [](const Played& run) {
    const auto& all = run.summary.warnings;
    return std::count_if(all.begin(), all.end(), [](const sim::Warning& w) { return w.kind == "stick_elements"; });
  };
  EXPECT_EQ(told(coarse({})), 1);
  EXPECT_EQ(told(coarse({{"size_mm = 0.012", "size_mm = 0.0045"}})), 0);
}

// Where one element is all that sticks, the depth of the end is unknown, and the warning must say that.
TEST(StickEdge, OneElementIsWarnedOf) {
  const auto run = coarse({{"force_N_per_mm = 36.0", "force_N_per_mm = 70.7"}});
  const auto& all = run.summary.warnings;
  const auto found = std::find_if(all.begin(), all.end(), [](const auto& w) { return w.kind == "stick_elements"; });
  ASSERT_NE(found, all.end());
  EXPECT_NE(found->text.find("without that element nothing would stick"), std::string::npos) << found->text;
  EXPECT_EQ(found->text.find("inf"), std::string::npos) << found->text;
}

}  // namespace reye::verification
