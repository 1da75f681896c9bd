#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "example.hpp"
#include "folder.hpp"
#include "scene/keys.hpp"
#include "scene/read.hpp"
#include "scene/scars.hpp"
#include "scene/schema.hpp"
#include "scene/sha256.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/spec.hpp"

using namespace reye;

namespace {

void expect_sound(std::span<const scene::Key> table) {
  std::set<std::string_view> patterns;
  for (const auto& key : table) {
    EXPECT_TRUE(patterns.insert(key.pattern).second) << key.pattern;
    EXPECT_FALSE(key.doc.empty()) << key.pattern;
    if (key.fallback.empty() || key.fallback == scene::required) continue;
    if (key.type == scene::Type::number || key.type == scene::Type::whole) {
      EXPECT_TRUE(key.range.holds(std::stod(std::string(key.fallback)))) << key.pattern;
    }
    if (key.range.choices.empty()) continue;
    const auto names = scene::split(key.range.choices, '|');
    EXPECT_EQ(std::count(names.begin(), names.end(), key.fallback), 1) << key.pattern;
  }
}

std::string in_geo(const std::string& name) {
  std::ifstream file(std::string(REYE_SOURCE_DIR) + "/geo/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The text between the markers of a table in geo/REFERENCE.md.
std::string table_of_page(const std::string& name) {
  const auto page = in_geo("REFERENCE.md");
  const std::string begin = "<!-- " + name + " reference: begin -->", end = "<!-- " + name + " reference: end -->";
  const auto from = page.find(begin), to = page.find(end);
  if (from == std::string::npos || to == std::string::npos) return {};
  auto found = page.substr(from + begin.size(), to - from - begin.size());
  found.erase(0, found.find_first_not_of('\n'));
  found.erase(found.find_last_not_of('\n') + 1);
  return found + '\n';
}

}  // namespace

/// Every key is documented, stands once, and keeps its own range with its default.
TEST(Keys, TableIsSound) {
  expect_sound(scene::keys());
  expect_sound(scene::solid_keys());
}

/// A key that both kinds of scenes take has one type, one unit and one default, but for points, boxes and forces, which
/// have as many numbers as space has directions, and for what solids take less of so far.
TEST(Keys, SharedKeysMeanTheSame) {
  const std::set<std::string_view> own = {
      "contact.*.friction", "step[].cycles", "load.*.traction_MPa", "load.*.force_N_per_mm3",
      "load.*.force_N",     "body.*.at",     "face.*.nearest_mm",   "contact.*.fine_zone[?].centre_mm"};
  for (const auto& key : scene::solid_keys())
    for (const auto& other : scene::keys()) {
      if (key.pattern != other.pattern || own.contains(key.pattern)) continue;
      if (key.type == scene::Type::refused || other.type == scene::Type::refused) continue;
      EXPECT_EQ(key.unit, other.unit) << key.pattern;
      const bool in_space = key.type == scene::Type::triple && other.type == scene::Type::pair;
      EXPECT_TRUE(key.type == other.type || in_space) << key.pattern;
    }
}

/// The reference has one row per key that can be given.
TEST(Keys, Reference) {
  const auto text = scene::reference();
  EXPECT_NE(text.find("| `material.*.nu` | number in (-1, 0.5) |  | required | Poisson's ratio |\n"),
            std::string::npos);
  EXPECT_NE(text.find("| `material.*.E_MPa` | number > 0 | MPa | required | Young's modulus |\n"), std::string::npos);
  EXPECT_NE(text.find("| `shape` | \"on\" or \"off\" |  | `on` | "), std::string::npos);
  for (const auto& key : scene::keys()) {
    const auto row = text.find("| `" + std::string(key.pattern) + "` |");
    EXPECT_EQ(row == std::string::npos, key.type == scene::Type::refused) << key.pattern;
  }
}

/// The tables in geo/REFERENCE.md are those made from the tables of keys.
TEST(Keys, PageHoldsTheReferences) {
  EXPECT_EQ(table_of_page("scene"), scene::reference()) << "put the text on the right between the markers";
  EXPECT_EQ(table_of_page("solid"), scene::solid_reference()) << "put the text on the right between the markers";
  EXPECT_EQ(table_of_page("scar"), scene::scar_reference()) << "put the text on the right between the markers";
}

/// The schema that editors read is that made from the tables of keys.
TEST(Keys, SchemaIsCommitted) {
  EXPECT_TRUE(in_geo("scene.schema.json") == scene::schema(scene::spec(), scene::solid_spec()))
      << "run apps/scene_reference.py";
}

/// Published digests (FIPS 180-4 examples), short, of two blocks, and at the padding's edge.
TEST(Sha256, PublishedDigests) {
  EXPECT_EQ(scene::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(scene::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(scene::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(scene::sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

/// The identity of a scene follows its own bytes and those of its geometry, not its place.
TEST(Sha256, OfAScene) {
  const auto hash = [](const std::string& scene, const std::string& step) {
    const test::Folder folder;
    test::Folder::write("scene.toml", scene);
    test::Folder::write("cylinder_on_flat.step", step);
    return scene::read("scene.toml").sha256;
  };
  const auto first = hash(test::example, "one");
  EXPECT_EQ(first.size(), 64U);
  EXPECT_EQ(first, hash(test::example, "one"));
  EXPECT_NE(first, hash(test::example, "two"));
  EXPECT_NE(first, hash(test::replaced(test::example, "0.9", "0.8"), "one"));
}

/// The identity follows the bytes of the profiles too.
TEST(Sha256, OfAProfile) {
  const auto hash = [](const std::string& height) {
    const test::Folder folder;
    test::Folder::write("scene.toml", test::replaced(test::example, R"(type = "circle")", R"(profile = "a.csv")"));
    test::Folder::write("cylinder_on_flat.step", "one");
    test::Folder::write("a.csv", "arc_length_mm,height_mm\n0,0\n1," + height + "\n2,0\n");
    return scene::read("scene.toml").sha256;
  };
  EXPECT_EQ(hash("0.1"), hash("0.1"));
  EXPECT_NE(hash("0.1"), hash("0.10"));
}
