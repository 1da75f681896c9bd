#include <gtest/gtest.h>

#include "scene/solid/solid_extension.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/solid/solid_located.hpp"
#include "scene/sweep.hpp"
#include "solid_example.hpp"

using namespace reye;

namespace {

std::string edited_solid(const std::string& from, const std::string& to) {
  return test::replaced(test::solid_example, from, to);
}

}  // namespace

// More cycles of the last step must extend a run of solids, and keep its fixed part; another value must be refused.
TEST(SolidExtension, MoreCycles) {
  const auto was = test::solid_scene(test::solid_example);
  const auto more = test::solid_scene(edited_solid("cycles = 3", "cycles = 5"));
  EXPECT_EQ(more.fixed_sha256, was.fixed_sha256);
  const auto extension = scene::extension_of(was.text, was.fixed_sha256, more);
  EXPECT_EQ(extension.cycles_key, "step[1].cycles");
  EXPECT_EQ(extension.changes, std::vector<std::string>{"step[1].cycles = 5: was 3 in the run to be resumed"});
  const auto other = test::solid_scene(edited_solid("friction  = 0.3", "friction  = 0.2"));
  EXPECT_THROW(scene::extension_of(was.text, was.fixed_sha256, other), base::InputError);
}

// A geometry file and a measured history that have changed must be named each with the key that names it, those that
// are the same or new must not.
TEST(SolidExtension, ChangedFiles) {
  const test::SolidFolder folder;
  test::Folder::write("load.csv", "progress,press\n0,0\n1,1\n");
  const auto text =
      edited_solid("press = [[0.0, 0.0], [1.0, 1.0]]", "press = { file = \"./load.csv\", column = \"press\" }");
  const auto read = [&] { return scene::read_solid_text(text, "scene.toml"); };
  const auto was = read();
  EXPECT_EQ(was.file_sha256.size(), 2u);
  EXPECT_TRUE(was.file_sha256.contains("ball_on_flat.step") && was.file_sha256.contains("load.csv"));
  EXPECT_TRUE(scene::changed_files(read(), was.file_sha256).empty());
  EXPECT_TRUE(scene::changed_files(read(), {}).empty());
  test::Folder::write("load.csv", "progress,press\n0,0\n1,1.0\n");
  test::Folder::write("ball_on_flat.step", "ISO-10303-21; ");
  const auto issues = scene::changed_files(read(), was.file_sha256);
  ASSERT_EQ(issues.size(), 2u);
  EXPECT_EQ(issues[0].key, "geometry");
  EXPECT_EQ(issues[0].value, "\"ball_on_flat.step\"");
  EXPECT_EQ(issues[1].key, "history.press.file");
  EXPECT_EQ(issues[1].rule, "its content differs from that in the run to be resumed");
}

// A sweep of solids must take their keys, put the values there and find the geometry from elsewhere.
TEST(SolidExtension, Sweep) {
  const test::SolidFolder folder;
  test::Folder::write("scene.toml", test::solid_example);
  const auto sweep =
      scene::sweep_of("scene.toml", {"contact.pad.friction=0.1,0.2", "step[1].cycles=4"}, scene::solid_spec());
  ASSERT_EQ(sweep.members.size(), 2u);
  const auto member = scene::read_solid_text(sweep.members[1].text, "elsewhere/scene.toml");
  EXPECT_EQ(member.contacts[0].friction, 0.2);
  EXPECT_EQ(member.steps[1].cycles, 4.0);
  EXPECT_EQ(member.geometry.files, scene::read_solid("scene.toml").geometry.files);
  EXPECT_THROW(scene::sweep_of("scene.toml", {"contact.pad.frction=0.1"}, scene::solid_spec()), base::InputError);
}
