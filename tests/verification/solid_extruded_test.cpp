#include "support/extruded.hpp"
#include "support/solid_problem.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;
using base::Vec3;

namespace {

constexpr double layer = 0.4;  // mm

/// Two blocks pressed and pushed: the upper one's top is moved by node, the lower one's bottom is fixed.
std::string pushed_blocks(const std::string& friction) {
  return "title = \"blocks\"\nanalysis = \"plane_strain\"\ngeometry = [\"blocks.geo\"]\n"
         "material.steel = { E_MPa = 2.0e5, nu = 0.3 }\n"
         "body.slider = { material = \"steel\", mesh = { element = \"quad\", far_size_mm = 0.5 } }\n"
         "body.base = { material = \"steel\", mesh = { element = \"quad\", far_size_mm = 0.7 } }\n"
         "contact.pad = { secondary = \"slider_bottom\", primary = [\"base_top\"], friction = " +
         friction +
         " }\n"
         "support.holder = { edge = \"slider_top\", x = { motion_mm = 0.004, history = \"push\" }, "
         "y = { motion_mm = -0.01, history = \"press\" } }\n"
         "support.base = { edge = \"base_bottom\", x = \"fixed\", y = \"fixed\" }\n"
         "history = { press = [[0, 0], [1, 1]], push = [[0, 0], [1, 1]] }\n"
         "[[step]]\nname = \"press\"\nplay = [\"press\"]\nincrements = 2\nwear = false\n"
         "[[step]]\nname = \"push\"\nplay = [\"push\"]\nincrements = 4\nwear = false\n";
}

sim::SolidProblem extruded_blocks(const sim::Problem& plane, double friction) {
  std::vector<body::SolidInput> inputs;
  for (int b = 0; b < 2; ++b) {
    inputs.push_back(support::solid(plane.inputs[b].name, support::extruded(plane.shapes[b]->mesh, layer), 2.0e5, 0.3));
    inputs.back().supports = {support::symmetry("front", "z0"), support::symmetry("back", "z1")};
  }
  inputs[0].supports.push_back(support::by_node(
      "holder", "slider_top", {support::moved(0.004, "push"), support::moved(-0.01, "press"), body::Motion{}}));
  inputs[1].supports.push_back(
      support::by_node("base", "base_bottom", {support::fixed_motion(), support::fixed_motion(), body::Motion{}}));
  auto problem = support::problem_of(std::move(inputs), {0, "slider_bottom"}, {1, "base_top"}, friction, 0.2);
  for (const char* name : {"press", "push"}) problem.scene.histories[name] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.steps = {support::step_of(2, {"press"}), support::step_of(4, {"push"})};
  return problem;
}

/// Largest difference of pressures, and of shears, between the plane and both layers of nodes of the solid, over the
/// largest pressure.
double largest_difference(const sim::SurfaceRecord& plane, const sim::SkinRecord& solid, int nodes) {
  std::map<int, std::array<double, 2>> expected;
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < plane.node.size(); ++i) {
    expected[plane.node[i]] = {plane.pressure_MPa[i], std::abs(plane.shear_MPa[i])};
    largest = std::max(largest, plane.pressure_MPa[i]);
  }
  for (std::size_t j = 0; j < solid.node.size(); ++j) {
    const auto& [p, t] = expected.at(solid.node[j] % nodes);
    worst = std::max({worst, std::abs(solid.pressure_MPa[j] - p), std::abs(solid.shear_MPa[j].norm() - t)});
  }
  return worst / largest;
}

/// The difference for two pressed and pushed blocks.
double difference_of_blocks(const std::string& friction) {
  const std::string geometry = std::string(REYE_SOURCE_DIR) + "/geo/sliding_block/blocks.geo";
  const auto plane = verification::played(
      verification::replaced(pushed_blocks(friction), {{"\"blocks.geo\"", "\"" + geometry + "\""}}));
  const auto solid = support::play(extruded_blocks(plane.problem, std::stod(friction)));
  EXPECT_EQ(solid.summary.status, sim::RunStatus::done) << solid.summary.reason;
  if (solid.frames.empty()) return 1.0;
  EXPECT_LE(solid.summary.balance, 1e-11);
  return largest_difference(plane.surface(sim::Side::secondary), solid.frames.back().surfaces.front(),
                            plane.problem.shapes[0]->mesh.node_count());
}

body::SolidLoad side_traction(const std::string& face, double t) {
  body::SolidLoad load;
  load.name = face;
  load.face = face;
  load.traction_MPa = {0.0, t, 0.0};
  load.history = "press";
  return load;
}

/// geo/sliding_block as it is pressed: uniform pressure and shear.
sim::SolidProblem extruded_sliding_block(const sim::Problem& plane) {
  std::vector<body::SolidInput> inputs;
  for (int b = 0; b < 2; ++b) {
    inputs.push_back(support::solid(plane.inputs[b].name, support::extruded(plane.shapes[b]->mesh, layer), 2.0e8, 0.0));
    inputs.back().supports = {support::symmetry("front", "z0"), support::symmetry("back", "z1")};
    inputs.back().loads = {side_traction(inputs.back().name + "_right", 3.0),
                           side_traction(inputs.back().name + "_left", -3.0)};
  }
  body::SolidSupport holder;
  holder.name = "holder";
  holder.face = "slider_top";
  holder.rigid = true;
  holder.along = {support::moved(3.0e-7, "press"), support::loaded(-100.0 * layer, "press"), support::fixed_motion()};
  for (auto& motion : holder.about) motion = support::fixed_motion();
  inputs[0].supports = {holder};
  inputs[1].supports.push_back(support::by_node(
      "base", "base_bottom", {support::fixed_motion(), support::fixed_motion(), support::fixed_motion()}));
  auto problem = support::problem_of(std::move(inputs), {0, "slider_bottom"}, {1, "base_top"}, 0.5, 0.2);
  problem.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.steps = {support::step_of(1, {"press"})};
  return problem;
}

}  // namespace

TEST(SolidExtruded, ABlockOnAPlaneInterfaceIsThePlanesOwn) {
  // geo/sliding_block, drawn out into one layer of solids without motion across it, has the plane's pressure and shear
  // at each node: its interface stays plane.
  std::string text = verification::scene_text("sliding_block");
  text = text.substr(0, text.find("[[step]]\nname = \"slide\""));
  const auto plane = verification::played(verification::replaced(
      text, {{"friction  = 0.3", "friction  = 0.5"},
             {"imposed_sliding_mm = 100.0", ""},
             {"wear      = { law = \"energy\", secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4 }", ""}}));
  const auto solid = support::play(extruded_sliding_block(plane.problem));
  ASSERT_EQ(solid.summary.status, sim::RunStatus::done) << solid.summary.reason;
  EXPECT_LE(largest_difference(plane.surface(sim::Side::secondary), solid.frames.back().surfaces.front(),
                               plane.problem.shapes[0]->mesh.node_count()),
            1e-10);
}

TEST(SolidExtruded, PressedAndPushedBlocksAreThePlanesOwn) {
  // Two blocks, pressed and pushed, and drawn out into one layer of solids without motion across it, have the plane's
  // pressures at each node; with friction, in partial slip and in stick, pressures and shears differ by 1e-7, since the
  // normals of the interface, which bends a little, are not the same.
  EXPECT_LE(difference_of_blocks("0.0"), 1e-10);
  for (const char* friction : {"0.3", "0.8"})
    EXPECT_LE(difference_of_blocks(friction), 2e-7) << "friction " << friction;
}
