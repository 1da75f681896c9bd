#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "example.hpp"
#include "folder.hpp"
#include "scene/document.hpp"
#include "scene/read.hpp"
#include "scene/rewrite.hpp"
#include "scene/sweep.hpp"

using namespace reye;

namespace {

/// The text with the value set; fails when it cannot be.
std::string set(const std::string& text, const std::string& key, const std::string& value) {
  const auto changed = scene::with_value(text, key, value);
  EXPECT_TRUE(changed) << key;
  return changed.value_or("");
}

/// What the variations are refused with; empty when they are accepted.
std::string sweep_refusal(const std::vector<std::string>& variations) {
  const test::Folder folder;
  test::Folder::write("scene.toml", test::example);
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  try {
    scene::sweep_of("scene.toml", variations);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

/// A value that stands in the text is replaced there, and nothing else changes.
TEST(Rewrite, ReplacesWhatIsWritten) {
  const std::string text = test::example;
  EXPECT_EQ(set(text, "contact.pad.friction", "0.5"), test::replaced(text, "friction  = 0.9", "friction  = 0.5"));
  EXPECT_EQ(
      set(text, "body.flat.mesh.far_size_mm", "1"),
      test::replaced(text, "[0.0, -3.0]\nmaterial = \"steel\"\nmesh     = { element = \"quad\", far_size_mm = 0.8",
                     "[0.0, -3.0]\nmaterial = \"steel\"\nmesh     = { element = \"quad\", far_size_mm = 1"));
  EXPECT_EQ(set(text, "step[2].jump", "50"), test::replaced(text, "jump = 100 ", "jump = 50 "));
  EXPECT_EQ(set(text, "history.stroke[1][0]", "0.3"), test::replaced(text, "[0.25, 1.0]", "[0.3, 1.0]"));
  EXPECT_EQ(set(text, "analysis", R"("plane_stress")"), test::replaced(text, R"("plane_strain")", R"("plane_stress")"));
  EXPECT_EQ(set("a = \"µ\" \nb = [1,\n 2] # end\n", "b", "3"), "a = \"µ\" \nb = 3 # end\n");
}

/// A value that does not stand there is added to its table, however that is written.
TEST(Rewrite, AddsWhatIsNot) {
  EXPECT_EQ(set("[a.b] # c\nx = 1\n", "a.b.y.z", "2"), "[a.b] # c\ny.z = 2\nx = 1\n");
  EXPECT_EQ(set("[a.b]", "a.b.y", "2"), "[a.b]\ny = 2\n");
  EXPECT_EQ(set("[[s]]\nx = 1\n[[s]]\nx = 2\n", "s[1].y", "3"), "[[s]]\nx = 1\n[[s]]\ny = 3\nx = 2\n");
  EXPECT_EQ(set("a = { x = 1 }\n", "a.y", "2"), "a = { y = 2, x = 1 }\n");
  EXPECT_EQ(set("a = {}\n", "a.y", "2"), "a = { y = 2 }\n");
  EXPECT_EQ(set("[a]\nb.x = 1\n", "a.b.y", "2"), "[a]\nb.y = 2\nb.x = 1\n");
  EXPECT_EQ(set("q = 0\n[a.b]\nx = 1\n", "a.y", "2"), "q = 0\n[a]\ny = 2\n[a.b]\nx = 1\n");
  EXPECT_EQ(set("[a]\nx = 1\n", "b.y", "2"), "b.y = 2\n[a]\nx = 1\n");
}

/// A plain value in the way becomes a table, and the other way round.
TEST(Rewrite, ValueAndTable) {
  EXPECT_EQ(set("jump = 100 # c\n", "jump.tolerance", "0.01"), "jump = { tolerance = 0.01 } # c\n");
  EXPECT_EQ(set("jump = { tolerance = 0.01 }\n", "jump", "100"), "jump = 100\n");
}

/// What cannot be put there gives nothing: a table with a header has no value, a value that is no TOML breaks the text.
TEST(Rewrite, RefusesWhatCannotBe) {
  EXPECT_FALSE(scene::with_value("[a]\nx = 1\n", "a", "2"));
  EXPECT_FALSE(scene::with_value("[[s]]\nx = 1\n", "s[0]", "2"));
  EXPECT_FALSE(scene::with_value("x = 1\n", "x", "1 2"));
  EXPECT_FALSE(scene::with_value("x = 1\n", "x", "1\ny = 2"));
}

/// Paths of geometry and profiles become absolute; put anywhere, the text reads as the same scene.
TEST(Rewrite, AbsolutePaths) {
  const test::Folder folder;
  const auto text = test::replaced(test::example, R"(type = "circle")", R"(profile = "a.csv")");
  test::Folder::write("scene.toml", text);
  test::Folder::write("cylinder_on_flat.step", "one");
  test::Folder::write("a.csv", "arc_length_mm,height_mm\n0,0\n1,0.1\n2,0\n");
  const auto moved = scene::read_text(scene::with_absolute_paths(text, "scene.toml"), "else/where/scene.toml");
  const auto here = scene::read("scene.toml");
  EXPECT_EQ(moved.geometry.files, here.geometry.files);
  EXPECT_EQ(moved.name, "where");
  ASSERT_TRUE(moved.geometry.boundaries[1].profile);
  EXPECT_EQ(moved.geometry.boundaries[1].profile->file, std::filesystem::canonical(folder.path() / "a.csv"));
}

/// Ranges hold both ends, ratios are equal where they are logarithmic, lists keep lists and quote texts.
TEST(Sweep, Variations) {
  using Values = std::vector<std::string>;
  EXPECT_EQ(scene::variation_of("a.b=0.3:0.9:4").values, (Values{"0.3", "0.5", "0.7", "0.9"}));
  EXPECT_EQ(scene::variation_of("a.b=log:1e-5:1e-3:3").values, (Values{"1e-05", "1e-04", "0.001"}));
  EXPECT_EQ(scene::variation_of("a.b=40:10:2").values, (Values{"40", "10"}));
  EXPECT_EQ(scene::variation_of("a.b=0.5").values, (Values{"0.5"}));
  EXPECT_EQ(scene::variation_of("a.b=quad,tri,true,2,'x,y'").values,
            (Values{"\"quad\"", "\"tri\"", "true", "2", "'x,y'"}));
  EXPECT_EQ(scene::variation_of("a.b=[0, 1],[0, 2]").values, (Values{"[0, 1]", "[0, 2]"}));
  EXPECT_EQ(scene::variation_of("step[2].jump=1").key, "step[2].jump");
}

/// The grid is full, its last key runs fastest, and each member holds its values.
TEST(Sweep, Grid) {
  const test::Folder folder;
  test::Folder::write("scene.toml", test::example);
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  const auto sweep = scene::sweep_of("scene.toml", {"contact.pad.friction=0.6,0.9", "step[2].jump=50:150:3"});
  EXPECT_EQ(sweep.keys, (std::vector<std::string>{"contact.pad.friction", "step[2].jump"}));
  ASSERT_EQ(sweep.members.size(), 6U);
  EXPECT_EQ(sweep.members[4].values, (std::vector<std::string>{"0.9", "100"}));
  const auto scene = scene::read_text(sweep.members[5].text, "member/scene.toml");
  EXPECT_EQ(scene.contacts[0].friction, 0.9);
  EXPECT_EQ(scene.steps[2].jump, 150.0);
}

/// One of several fine zones is varied by its index, a single one without.
TEST(Sweep, FineZones) {
  const test::Folder folder;
  const std::string one = "{ centre_mm = [0.0, 0.0], half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010 }";
  const auto size = [&](const std::string& zones, const std::string& variation, std::size_t zone) {
    test::Folder::write("scene.toml", test::replaced(test::example, one, zones));
    test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
    const auto sweep = scene::sweep_of("scene.toml", {variation});
    return scene::read_text(sweep.members.at(0).text, "member/scene.toml").geometry.fine_zones.at(zone).size_mm;
  };
  EXPECT_EQ(size(one, "contact.pad.fine_zone.size_mm=0.02", 0), 0.02);
  EXPECT_EQ(size("[" + one + ", " + one + "]", "contact.pad.fine_zone[1].size_mm=0.03", 1), 0.03);
  EXPECT_EQ(size("[" + one + ", " + one + "]", "contact.pad.fine_zone[1].size_mm=0.03", 0), 0.01);
  EXPECT_THROW(size("[" + one + "]", "contact.pad.fine_zone.size_mm=0.03", 0), base::InputError)
      << "it needs its index";
  EXPECT_THROW(size("[" + one + "]", "contact.pad.fine_zone[1].size_mm=0.03", 0), base::InputError)
      << "there is one zone";
}

/// All errors of the variations are reported at once, each with its rule.
TEST(Sweep, Refusals) {
  const std::string range =
      "must be key=a:b:n or key=log:a:b:n, numbers a and b (for log both > 0) and a whole number n >= 2, or "
      "key=v1,v2,...";
  EXPECT_EQ(sweep_refusal({}), "--vary: missing; a sweep varies at least one key");
  EXPECT_EQ(
      sweep_refusal({"friction", "contact.pad.frction=0.3", "contact.pd.friction=0.3", "step[7].jump=1", "step.jump=1",
                     "contact.pad.friction=0:1", "contact.pad.friction=log:0:1:3", "contact.pad.friction=0:1:2.5",
                     "contact.pad.friction=0.1,,0.2", "contact.pad=1", "shape=on", "shape=off"}),
      "--vary = friction: must be key=a:b:n or key=v1,v2,...\n"
      "--vary = contact.pad.frction=0.3: unknown key; did you mean friction?\n"
      "--vary = contact.pd.friction=0.3: there is no contact \"pd\"; did you mean \"pad\"?\n"
      "--vary = step[7].jump=1: the scene has no step[7]\n"
      "--vary = step.jump=1: takes an index, as in step[0]\n"
      "--vary = contact.pad.friction=0:1: " +
          range +
          "\n"
          "--vary = contact.pad.friction=log:0:1:3: " +
          range +
          "\n"
          "--vary = contact.pad.friction=0:1:2.5: " +
          range +
          "\n"
          "--vary = contact.pad.friction=0.1,,0.2: a value is empty\n"
          "--vary = contact.pad=1: cannot be put there\n"
          "--vary = shape=off: varies shape a second time");
  EXPECT_EQ(sweep_refusal({"step[0].increments=1:400:400", "step[1].increments=1:400:400"}),
            "--vary: a sweep may have at most 1e+05 members");
}
