#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "example.hpp"
#include "scene/read.hpp"
#include "scene/solid/solid_located.hpp"
#include "solid_example.hpp"

using namespace reye;
using base::Vec3;
using body::Drive;

/// A scene is one of solids when its analysis says so, and a file that cannot be read is none.
TEST(SolidScene, IsToldByItsAnalysis) {
  const test::SolidFolder folder;
  test::Folder::write("solid.toml", test::solid_example);
  test::Folder::write("plane.toml", test::example);
  test::Folder::write("broken.toml", "analysis = \"solid\"\n[[");
  EXPECT_TRUE(scene::is_solid("solid.toml"));
  EXPECT_FALSE(scene::is_solid("plane.toml"));
  EXPECT_FALSE(scene::is_solid("broken.toml"));
  EXPECT_FALSE(scene::is_solid("none.toml"));
}

/// Bodies, faces and fine zones arrive as written, with the defaults of the table.
TEST(SolidScene, Geometry) {
  const auto scene = test::solid_scene(test::solid_example);
  const auto& geometry = scene.geometry;
  ASSERT_EQ(geometry.bodies.size(), 3U);
  EXPECT_EQ(*geometry.bodies[0].at, Vec3(1.0, 1.0, 40.0));
  EXPECT_EQ(geometry.bodies[0].mesh.element, mesh::SolidKind::tet10);
  EXPECT_EQ(geometry.bodies[0].mesh.far_size_mm, 6.0);
  EXPECT_EQ(geometry.bodies[0].mesh.growth, 1.3);
  EXPECT_EQ(geometry.bodies[1].mesh.element, mesh::SolidKind::tet4);
  EXPECT_EQ(*geometry.bodies[1].label, "Base plate");
  EXPECT_TRUE(geometry.bodies[2].rigid);
  ASSERT_EQ(geometry.faces.size(), 5U);
  EXPECT_EQ(*geometry.faces[0].type, "sphere");
  EXPECT_EQ((*geometry.faces[1].box_mm)[2], 49.9);
  EXPECT_EQ((*geometry.faces[1].box_mm)[5], 50.1);
  EXPECT_EQ(*geometry.faces[2].nearest_mm, Vec3(0.0, 0.0, 0.0));
  ASSERT_EQ(geometry.fine_zones.size(), 2U);
  EXPECT_EQ(geometry.fine_zones[0].radius_mm, 2.0);
  EXPECT_EQ(geometry.fine_zones[0].bodies, (std::vector<std::string>{"flat", "ball"}));
  EXPECT_EQ(geometry.fine_zones[1].half_widths_mm, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(geometry.fine_zones[1].radius_mm, 0.0);
  EXPECT_EQ(scene.body_material, (std::map<std::string, std::string>{{"ball", "steel"}, {"flat", "steel"}}));
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
}

/// Imposed sliding has directions of length one, turns have an axis, and both their parts.
TEST(SolidScene, Contacts) {
  const auto scene = test::solid_scene(test::solid_example);
  ASSERT_EQ(scene.contacts.size(), 2U);
  const auto& pad = scene.contacts[0];
  EXPECT_EQ(pad.secondary, "flat_contact");
  EXPECT_EQ(pad.friction, 0.3);
  EXPECT_EQ(pad.dual, mortar::SkinDual::quadratic);
  ASSERT_EQ(pad.sliding.size(), 2U);
  EXPECT_EQ(pad.sliding[0].direction, Vec3(0.0, 1.0, 0.0));
  EXPECT_EQ(pad.sliding[0].parts[0].value, 0.4);
  EXPECT_EQ(pad.sliding[0].parts[0].history, "rub");
  EXPECT_TRUE(pad.sliding[1].direction.isZero(0.0));
  EXPECT_EQ(pad.sliding[1].axis, Vec3(0.0, 0.0, 1.0));
  EXPECT_EQ(scene.contacts[1].friction, 0.0);
}

/// A loaded motion or a rotation makes its face rigid, a normal does not; parts of a motion add up.
TEST(SolidScene, Supports) {
  const auto scene = test::solid_scene(test::solid_example);
  ASSERT_EQ(scene.supports.size(), 5U);
  const auto& holder = scene.supports[0];
  EXPECT_TRUE(holder.rigid);
  EXPECT_EQ(holder.along[0].drive, Drive::fixed);
  EXPECT_EQ(holder.along[1].drive, Drive::moved);
  ASSERT_EQ(holder.along[1].parts.size(), 2U);
  EXPECT_EQ(holder.along[1].parts[1].value, 0.2);
  EXPECT_EQ(holder.along[2].drive, Drive::loaded);
  EXPECT_EQ(holder.along[2].parts[0].value, -500.0);
  EXPECT_EQ(holder.about[0].drive, Drive::fixed);
  EXPECT_EQ(holder.about[1].drive, Drive::moved);
  EXPECT_EQ(holder.about[2].drive, Drive::loaded);
  EXPECT_EQ(holder.about[2].stiffness, 50.0);
  EXPECT_EQ(*holder.centre_mm, Vec3(0.0, 0.0, 50.0));
  const auto& stop = scene.supports[1];
  EXPECT_TRUE(stop.rigid);
  EXPECT_EQ(stop.body, "stop");
  EXPECT_EQ(stop.along[2].stiffness, 1000.0);
  EXPECT_EQ(stop.along[2].parts[0].value, 20.0);  // of the spring's far end
  const auto& slope = scene.supports[2];
  EXPECT_FALSE(slope.rigid);
  EXPECT_EQ(slope.normal.drive, Drive::moved);
  EXPECT_EQ(slope.normal.parts[0].value, 0.1);
}

/// A symmetric face is a support that is fixed along its normal, and issues of it are those of the key.
TEST(SolidScene, Symmetry) {
  const auto scene = test::solid_scene(test::solid_example);
  EXPECT_EQ(scene.symmetry, (std::vector<std::string>{"ball_sx", "flat_sx"}));
  const auto& support = scene.supports[3];
  EXPECT_EQ(support.face, "ball_sx");
  EXPECT_EQ(support.normal.drive, Drive::fixed);
  EXPECT_FALSE(support.rigid);
  const auto error = scene::located(scene, {{"support." + support.name + ".face", "", "names no face"}});
  EXPECT_EQ(std::string(error.what()).rfind("scene.toml:4: support.", 0), 0U) << error.what();
}

/// Axes of a support are orthogonal, right-handed and of length one; one direction alone leaves the other near its own.
TEST(SolidScene, Axes) {
  const auto axes = [](const std::string& written) {
    const auto scene = test::solid_scene(
        test::replaced(test::solid_example, "axis_z = [0.0, 0.0, 2.0]\naxis_x = [1.0, 1.0, 0.0]\n", written));
    return scene.supports[1].axes;
  };
  base::Mat3 turned;
  const double r = std::sqrt(0.5);
  turned << r, -r, 0.0, r, r, 0.0, 0.0, 0.0, 1.0;
  EXPECT_LT((axes("axis_z = [0.0, 0.0, 2.0]\naxis_x = [1.0, 1.0, 0.0]\n") - turned).norm(), 1e-15);
  EXPECT_LT((axes("axis_x = [1.0, 1.0, 0.0]\n") - turned).norm(), 1e-15);
  EXPECT_EQ(axes(""), base::Mat3::Identity());
  for (const auto* written :
       {"axis_z = [1.0, 2.0, 3.0]\n", "axis_z = [1.0, 0.1, 0.0]\n", "axis_x = [0.0, 0.1, -1.0]\n"}) {
    const auto found = axes(written);
    EXPECT_LT((found.transpose() * found - base::Mat3::Identity()).norm(), 1e-15) << written;
    EXPECT_NEAR(found.determinant(), 1.0, 1e-15) << written;
  }
  EXPECT_LT((axes("axis_z = [1.0, 0.0, 0.0]\n").col(0) - Vec3::UnitY()).norm(), 1e-15);
}

/// Each part of a load is a load; a force per volume has its body.
TEST(SolidScene, Loads) {
  const auto scene = test::solid_scene(test::solid_example);
  ASSERT_EQ(scene.loads.size(), 4U);
  EXPECT_EQ(scene.loads[0].pressure_MPa, 5.0);
  EXPECT_EQ(scene.loads[0].history, "press");
  EXPECT_EQ(scene.loads[1].traction_MPa, Vec3(0.0, 0.0, 1.0));
  EXPECT_EQ(scene.loads[2].force_N, Vec3(10.0, 0.0, 0.0));
  EXPECT_EQ(scene.loads[2].face, "flat_side");
  EXPECT_EQ(scene.loads[3].body, "flat");
  EXPECT_EQ(scene.loads[3].force_N_per_mm3, Vec3(0.0, 0.0, -7.7e-5));
}

/// Steps count their cycles and may wear; what is written is output.
TEST(SolidScene, StepsAndOutput) {
  const auto scene = test::solid_scene(test::solid_example);
  ASSERT_EQ(scene.steps.size(), 2U);
  EXPECT_EQ(scene.steps[0].cycles, 0.0);
  EXPECT_EQ(scene.steps[1].cycles, 3.0);
  EXPECT_TRUE(scene.steps[1].wear);
  EXPECT_EQ(scene.steps[1].jump, 1.0);
  EXPECT_EQ(scene.steps[1].increments, 20);
  EXPECT_TRUE(scene.frames.every_increment);
  EXPECT_EQ(scene.frames.per_step, 0);
  ASSERT_EQ(scene.probes.size(), 1U);
  EXPECT_EQ(scene.probes[0].at_mm, Vec3(5.0, 0.0, 0.0));
  EXPECT_EQ(scene.max_newton, 30);
  EXPECT_EQ(scene.checkpoint_s, 1.0);
}

/// A measured history is read from its file and belongs to the identity of the scene.
TEST(SolidScene, MeasuredHistory) {
  const auto read = [](const std::string& rows) {
    const test::SolidFolder folder;
    test::Folder::write(
        "scene.toml", test::replaced(test::solid_example, "rub   = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]",
                                     "rub = { file = \"rub.csv\" }"));
    test::Folder::write("rub.csv", "time_s,factor\n" + rows);
    return scene::read_solid("scene.toml");
  };
  const auto scene = read("0,0\n1,1\n2,0\n");
  EXPECT_EQ(scene.histories.at("rub"), (scene::History{{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}}));
  EXPECT_EQ(scene.measured.at("rub").duration_s, 2.0);
  EXPECT_NE(scene.sha256, read("0,0\n1,2\n2,0\n").sha256);
}

/// Values that no solid has are warnings, in the words of plane scenes.
TEST(SolidScene, Suspicious) {
  auto text = test::replaced(test::solid_example, "210e3", "210e9");
  text = test::replaced(text, "friction  = 0.3", "friction  = 30");
  text = test::replaced(text, "motion_mm = 0.02", "motion_mm = 0.00002");
  text = test::replaced(text, "[history]\n", "[history]\nidle = [[0, 0], [1, 1]]\n");
  const auto scene = test::solid_scene(text);
  ASSERT_EQ(scene.warnings.size(), 5U);
  EXPECT_EQ(scene.warnings[0].rfind("scene.toml:7: material.steel.E_MPa = 210e9: no solid has more", 0), 0U);
  EXPECT_EQ(scene.warnings[1].rfind("scene.toml:34: contact.pad.friction = 30: no dry contact", 0), 0U);
  EXPECT_EQ(scene.warnings[2].rfind("scene.toml:57: support.stop.z.motion_mm = 0.00002: moves by", 0), 0U);
  EXPECT_EQ(scene.warnings[3], "scene.toml:74: history.idle: no step plays it; its factor stays 0");
}
