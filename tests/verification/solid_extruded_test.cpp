#include "support/solid_problem.hpp"
#include "support/swept.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;
using base::Vec3;

namespace {

constexpr double layer = 0.4;  // mm

/// Two blocks pressed and pushed: the upper one's top is moved by node, the lower one's bottom is fixed.
std::string pushed_blocks(const std::string& friction, double share) {
  return "title = \"blocks\"\nanalysis = \"plane_strain\"\ngeometry = [\"blocks.geo\"]\n"
         "material.steel = { E_MPa = 2.0e5, nu = 0.3 }\n"
         "body.slider = { material = \"steel\", mesh = { element = \"quad\", far_size_mm = 0.5 } }\n"
         "body.base = { material = \"steel\", mesh = { element = \"quad\", far_size_mm = 0.7 } }\n"
         "contact.pad = { secondary = \"slider_bottom\", primary = [\"base_top\"], friction = " +
         friction +
         " }\n"
         "support.holder = { edge = \"slider_top\", x = { motion_mm = " +
         verification::number(0.004 * share) +
         ", history = \"push\" }, y = { motion_mm = " + verification::number(-0.01 * share) +
         ", history = \"press\" } }\n"
         "support.base = { edge = \"base_bottom\", x = \"fixed\", y = \"fixed\" }\n"
         "history = { press = [[0, 0], [1, 1]], push = [[0, 0], [1, 1]] }\n"
         "[[step]]\nname = \"press\"\nplay = [\"press\"]\nincrements = 2\nwear = false\n"
         "[[step]]\nname = \"push\"\nplay = [\"push\"]\nincrements = 4\nwear = false\n";
}

sim::SolidProblem extruded_blocks(const sim::Problem& plane, double friction, double share) {
  std::vector<body::SolidInput> inputs;
  for (int b = 0; b < 2; ++b) {
    inputs.push_back(support::solid(plane.inputs[b].name, support::extruded(plane.shapes[b]->mesh, layer), 2.0e5, 0.3));
    inputs.back().supports = {support::symmetry("front", "z0"), support::symmetry("back", "z1")};
  }
  inputs[0].supports.push_back(support::by_node(
      "holder", "slider_top",
      {support::moved(0.004 * share, "push"), support::moved(-0.01 * share, "press"), body::Motion{}}));
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
double difference_of_blocks(const std::string& friction, double share = 1.0) {
  const std::string geometry = std::string(REYE_SOURCE_DIR) + "/geo/sliding_block/blocks.geo";
  const auto plane = verification::played(
      verification::replaced(pushed_blocks(friction, share), {{"\"blocks.geo\"", "\"" + geometry + "\""}}));
  const auto solid = support::play(extruded_blocks(plane.problem, std::stod(friction), share));
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

/// A cylinder on a flat (geo/cattaneo_mindlin) as a plane scene, and drawn out; `elements` per half width.
struct Drawn {
  double pressure = 0.0, shear = 0.0;  ///< differences at the end, in the mean of squares over the area
  double energy = 0.0;                 ///< of the work dissipated
};

constexpr double cylinder_width = 0.0913360;  // mm, half

std::string cylinder_scene(double elements, const std::string& x, const std::string& histories,
                           const std::string& step) {
  std::string text = verification::scene_text("cattaneo_mindlin");
  text = text.substr(0, text.find("[load.unload]")) + text.substr(text.find("[support.base]"));
  text = text.substr(0, text.find("[history]")) + "[history]\npress = [[0.0, 0.0], [1.0, 1.0]]\nload = " + histories +
         "\n[[step]]\nname = \"press\"\nplay = [\"press\"]\nincrements = 2\nwear = false\n" + step;
  return verification::replaced(text,
                                {{"size_mm = 0.0045", "size_mm = " + verification::number(cylinder_width / elements)},
                                 {"{ force_N_per_mm = 36.0, history = \"load\" }", x}});
}

sim::SolidProblem extruded_cylinder(const sim::Problem& plane, const body::Motion& x, const scene::History& load,
                                    scene::Step step) {
  std::vector<body::SolidInput> inputs;
  const double nu = 0.3;
  for (int b = 0; b < 2; ++b) {
    inputs.push_back(support::solid(plane.inputs[b].name, support::extruded(plane.shapes[b]->mesh, layer), 2.0e5, nu));
    inputs.back().supports = {support::symmetry("front", "z0"), support::symmetry("back", "z1")};
  }
  body::SolidSupport holder, base;
  holder.name = "holder";
  holder.face = "top";
  holder.rigid = true;
  holder.along = {x, support::loaded(-120.0 * layer, "press"), support::fixed_motion()};
  base.name = "base";
  base.face = "bottom";
  base.rigid = true;
  base.along = {support::fixed_motion(), support::fixed_motion(), support::fixed_motion()};
  for (int k = 0; k < 3; ++k) holder.about[k] = base.about[k] = support::fixed_motion();
  inputs[0].supports.push_back(holder);
  inputs[1].supports.push_back(base);
  auto problem = support::problem_of(std::move(inputs), {1, "face"}, {0, "round"}, 0.6, 0.05);
  cad::SolidFineZone zone;
  zone.contact = "pad";
  zone.radius_mm = 0.17;
  problem.scene.geometry.fine_zones = {zone};
  problem.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.histories["load"] = load;
  problem.scene.steps = {support::step_of(2, {"press"}), std::move(step)};
  return problem;
}

Drawn difference(const verification::Played& plane, const support::PlayedSolids& solid) {
  Drawn drawn;
  const auto& surface = plane.surface(sim::Side::secondary);
  const auto& skin = solid.frames.back().surfaces.front();
  const int nodes = plane.problem.shapes[1]->mesh.node_count();
  std::map<int, std::array<double, 2>> expected;
  for (std::size_t i = 0; i < surface.node.size(); ++i)
    expected[surface.node[i]] = {surface.pressure_MPa[i], std::abs(surface.shear_MPa[i])};
  double pressure = 0.0, shear = 0.0;
  for (std::size_t j = 0; j < skin.node.size(); ++j) {
    const auto& [p, t] = expected.at(skin.node[j] % nodes);
    drawn.pressure += skin.area_mm2[j] * std::pow(skin.pressure_MPa[j] - p, 2);
    drawn.shear += skin.area_mm2[j] * std::pow(skin.shear_MPa[j].norm() - t, 2);
    pressure += skin.area_mm2[j] * p * p;
    shear += skin.area_mm2[j] * t * t;
  }
  drawn.pressure = std::sqrt(drawn.pressure / pressure);
  drawn.shear = shear > 0.0 ? std::sqrt(drawn.shear / shear) : 0.0;
  const double energy = plane.contact().dissipated_energy * layer;
  if (energy > 0.0) drawn.energy = solid.summary.contacts[0].dissipated_energy_mJ / energy - 1.0;
  return drawn;
}

Drawn cattaneo_mindlin(double elements) {
  const auto plane = verification::played(
      cylinder_scene(elements, "{ force_N_per_mm = 36.0, history = \"load\" }", "[[0, 0], [1, 1]]",
                     "[[step]]\nname = \"load\"\nplay = [\"load\"]\nincrements = 4\nwear = false\n"));
  const auto solid = support::play(extruded_cylinder(plane.problem, support::loaded(36.0 * layer, "load"),
                                                     {{0.0, 0.0}, {1.0, 1.0}}, support::step_of(4, {"load"})));
  EXPECT_EQ(solid.summary.status, sim::RunStatus::done) << solid.summary.reason;
  return difference(plane, solid);
}

/// A cycle in gross slip that ends at the far side.
Drawn gross_slip(double elements) {
  const auto plane = verification::played(
      cylinder_scene(elements, "{ motion_mm = 0.01, history = \"load\" }", "[[0, 0], [0.2, 1], [0.6, -1], [1, 1]]",
                     "[[step]]\nname = \"load\"\nplay = [\"load\"]\nincrements = 20\nwear = false\n"));
  const auto solid = support::play(extruded_cylinder(plane.problem, support::moved(0.01, "load"),
                                                     {{0.0, 0.0}, {0.2, 1.0}, {0.6, -1.0}, {1.0, 1.0}},
                                                     support::step_of(20, {"load"})));
  EXPECT_EQ(solid.summary.status, sim::RunStatus::done) << solid.summary.reason;
  return difference(plane, solid);
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
  // pressures at each node. With friction, in partial slip and in stick, pressures and shears differ by what the
  // normals of the interface do, which bends a little under load: it falls with the load, to nothing where the
  // interface is plane.
  EXPECT_LE(difference_of_blocks("0.0"), 1e-10);
  for (const char* friction : {"0.3", "0.8"}) {
    const double whole = difference_of_blocks(friction), tenth = difference_of_blocks(friction, 0.1);
    EXPECT_LE(whole, 2e-7) << "friction " << friction;
    EXPECT_LE(tenth, 0.12 * whole) << "friction " << friction;
  }
}

TEST(SolidExtruded, CylindersDifferByTheSquareOfTheElement) {
  // A cylinder on a flat in partial slip, and in a cycle of gross slip, drawn out: the plane projects along
  // interpolated normals, facets project along one each. What they differ by is far below 0.3 % and falls with the
  // element.
  const Drawn partial[2]{cattaneo_mindlin(10.0), cattaneo_mindlin(20.0)}, gross[2]{gross_slip(10.0), gross_slip(20.0)};
  EXPECT_LE(partial[0].pressure, 2e-7);
  EXPECT_LE(partial[1].pressure, 0.3 * partial[0].pressure);
  EXPECT_LE(partial[0].shear, 6e-5);
  EXPECT_LE(partial[1].shear, 0.35 * partial[0].shear);
  EXPECT_LE(gross[0].pressure, 1e-7);
  EXPECT_LE(gross[1].pressure, 0.5 * gross[0].pressure);
  for (const Drawn& one : {partial[0], partial[1], gross[0], gross[1]}) EXPECT_LE(std::abs(one.energy), 1e-4);
}
