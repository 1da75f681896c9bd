#include <gtest/gtest.h>

#include "example.hpp"
#include "folder.hpp"
#include "scene/read.hpp"

using namespace reye;

namespace {

scene::Scene read_example() {
  const test::Folder folder;
  test::Folder::write("scene.toml", test::example);
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  auto scene = scene::read("scene.toml");
  EXPECT_EQ(scene.geometry.files, std::vector{(folder.path() / "cylinder_on_flat.step").string()});
  EXPECT_EQ(scene.name, folder.path().filename().string());
  return scene;
}

}  // namespace

/// Bodies, materials and boundaries of the example reach the geometry stage as written.
TEST(Example, Bodies) {
  const auto s = read_example();
  EXPECT_EQ(s.title, "Cylinder on flat, fretting, McColl et al. 2004, 185 N on 10 mm");
  EXPECT_EQ(s.analysis, base::Analysis::plane_strain);
  EXPECT_FALSE(s.geometry.axisymmetric);
  const auto& steel = std::get<material::LinearElastic>(s.materials.at("steel"));
  EXPECT_EQ(steel.E_MPa, 200e3);
  EXPECT_EQ(steel.nu, 0.3);
  ASSERT_EQ(s.geometry.bodies.size(), 2U);
  const auto& cylinder = s.geometry.bodies[0];
  EXPECT_EQ(cylinder.name, "cylinder");
  EXPECT_EQ(*cylinder.at, base::Vec2(0.0, 3.0));
  EXPECT_FALSE(cylinder.label || cylinder.rigid);
  EXPECT_EQ(cylinder.mesh.element, mesh::CellKind::quad4);
  EXPECT_EQ(cylinder.mesh.far_size_mm, 0.8);
  EXPECT_EQ(cylinder.mesh.growth, 1.3);
  EXPECT_EQ(s.body_material.at("flat").material, "steel");
  EXPECT_FALSE(s.body_material.at("flat").b_bar);
  ASSERT_EQ(s.geometry.boundaries.size(), 4U);
  EXPECT_EQ(s.geometry.boundaries[0].name, "top");
  EXPECT_EQ(*s.geometry.boundaries[0].box_mm, (std::array{-6.1, 5.9, 6.1, 6.1}));
  EXPECT_EQ(*s.geometry.boundaries[1].type, "circle");
  EXPECT_EQ(*s.geometry.boundaries[2].nearest_mm, base::Vec2(0.0, 0.0));
  EXPECT_EQ(s.geometry.boundaries[2].body, "flat");
}

/// The contact has its law in consistent units, and its fine zone knows both bodies.
TEST(Example, Contact) {
  const auto s = read_example();
  ASSERT_EQ(s.contacts.size(), 1U);
  const auto& pad = s.contacts[0];
  EXPECT_EQ(pad.name, "pad");
  EXPECT_EQ(pad.secondary, "face");
  EXPECT_EQ(pad.primary, std::vector<std::string>{"round"});
  EXPECT_EQ(pad.friction, 0.9);
  EXPECT_EQ(pad.wear.kind, wear::LawKind::energy);
  EXPECT_DOUBLE_EQ(pad.wear.secondary, 3.222e-8);
  EXPECT_DOUBLE_EQ(pad.wear.primary, 2.111e-8);
  EXPECT_FALSE(pad.imposed);
  EXPECT_TRUE(pad.implicit_wear);
  EXPECT_EQ(pad.search_mm, 0.0);
  EXPECT_EQ(pad.c_normal, 1.0);
  EXPECT_EQ(pad.c_tangential, 1.0);
  ASSERT_EQ(s.geometry.fine_zones.size(), 1U);
  const auto& zone = s.geometry.fine_zones[0];
  EXPECT_EQ(zone.bodies, (std::vector<std::string>{"flat", "cylinder"}));
  EXPECT_EQ(zone.half_width_mm, 0.5);
  EXPECT_EQ(zone.depth_mm, 0.2);
  EXPECT_EQ(zone.size_mm, 0.010);
  EXPECT_EQ(zone.angle_deg, 0.0);
}

/// A support with a rotation named or a force is a rigid edge; forces and motions keep their histories.
TEST(Example, Supports) {
  const auto s = read_example();
  ASSERT_EQ(s.supports.size(), 2U);
  const auto &holder = s.supports[0], &shaker = s.supports[1];
  EXPECT_EQ(holder.edge, "top");
  EXPECT_TRUE(holder.rigid && shaker.rigid);
  EXPECT_FALSE(holder.edge_axes || holder.point_mm);
  EXPECT_EQ(holder.x.drive, body::Drive::fixed);
  EXPECT_EQ(holder.rotation.drive, body::Drive::fixed);
  EXPECT_EQ(holder.y.drive, body::Drive::loaded);
  EXPECT_EQ(holder.y.parts.at(0).value, -18.5);
  EXPECT_EQ(holder.y.parts.at(0).history, "press");
  EXPECT_EQ(shaker.x.drive, body::Drive::moved);
  EXPECT_EQ(shaker.x.parts.at(0).value, 0.025);
  EXPECT_EQ(shaker.x.parts.at(0).history, "stroke");
}

/// Steps, histories, limits and output, with the defaults of the table where the example is silent.
TEST(Example, Run) {
  const auto s = read_example();
  EXPECT_EQ(s.histories.at("stroke"), (scene::History{{0, 0}, {0.25, 1}, {0.75, -1}, {1, 0}}));
  ASSERT_EQ(s.steps.size(), 3U);
  EXPECT_EQ(s.steps[0].play, std::vector<std::string>{"press"});
  EXPECT_EQ(s.steps[0].increments, 10);
  EXPECT_FALSE(s.steps[1].wear);
  EXPECT_EQ(s.steps[1].cycles, 0.0);
  EXPECT_TRUE(s.steps[2].wear);
  EXPECT_EQ(s.steps[2].cycles, 18000.0);
  EXPECT_EQ(s.steps[2].jump, 100.0);
  ASSERT_EQ(s.limits.size(), 1U);
  EXPECT_EQ(s.limits[0].contact, "pad");
  EXPECT_EQ(s.limits[0].side, "secondary");
  EXPECT_EQ(*s.limits[0].depth_mm, 0.0025);
  EXPECT_FALSE(s.limits[0].area_mm2 || s.limits[0].stop);
  EXPECT_EQ(s.output.frames.every_cycles, 1000.0);
  EXPECT_FALSE(s.output.frames.every_increment);
  EXPECT_EQ(s.output.frames.every_blocks, 0);
  EXPECT_EQ(s.output.frames.per_decade, 0);
  EXPECT_FALSE(s.output.frames.at_remeshes);
  EXPECT_EQ(s.output.history_every_blocks, 1);
  EXPECT_EQ(s.output.checkpoint_s, 1.0);
  ASSERT_EQ(s.output.probes.size(), 1U);
  EXPECT_EQ(s.output.probes[0].at_mm, base::Vec2(0.5, 0.0));
  EXPECT_TRUE(s.shape);
  EXPECT_EQ(s.max_newton, 30);
  EXPECT_EQ(s.max_cutbacks, 8);
  EXPECT_TRUE(s.warnings.empty());
}

/// Each key has its line, so that rooms below can attach their issues to it.
TEST(Example, Lines) {
  const auto s = read_example();
  EXPECT_EQ(s.lines.at("material.steel.nu"), 8);
  EXPECT_EQ(s.lines.at("contact.pad.fine_zone.size_mm"), 31);
  EXPECT_EQ(s.lines.at("support.holder.y.history"), 37);
  EXPECT_EQ(s.lines.at("step[2].cycles"), 65);
  const auto error = scene::located(s, {{"step[2].increments[3]", "", "later"},
                                        {"support.holder.y.history", "\"press\"", "first"},
                                        {"nowhere.at.all", "1", "top"}});
  EXPECT_STREQ(error.what(),
               "scene.toml:1: nowhere.at.all = 1: top\n"
               "scene.toml:37: support.holder.y.history = \"press\": first\n"
               "scene.toml:64: step[2].increments[3]: later");
  EXPECT_EQ(error.issues().size(), 3U);
}
