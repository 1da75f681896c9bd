#include <sstream>

#include "command.hpp"

using namespace reye;
using test::holds;

namespace {

/// The kinds that the command shows, one a line.
std::vector<std::string> kinds(const test::Place& place) {
  std::vector<std::string> names;
  std::istringstream lines(place.reye({"new", "--list"}).out);
  for (std::string line; std::getline(lines, line);) {
    names.push_back(line.substr(0, line.find(' ')));
    EXPECT_GT(line.size(), 40u) << line << ": a line says what the kind is";
  }
  return names;
}

}  // namespace

// A folder of every kind must be made, titled with the name, and pass the check without a warning.
TEST(New, EveryKindIsChecked) {
  const test::Place place;
  const auto names = kinds(place);
  ASSERT_EQ(names, (std::vector<std::string>{"ball_on_flat", "bearing", "block_on_ring", "dovetail", "fretting",
                                             "hip_cup", "pin_on_disc", "seal"}));
  for (const auto& kind : names) {
    const auto made = place.reye({"new", "my_" + kind, "--like", kind});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(holds(test::read(place / ("my_" + kind + "/scene.toml")), "\ntitle    = \"my_" + kind + ": "));
    const auto checked = place.reye({"check", "my_" + kind + "/scene.toml"});
    EXPECT_EQ(checked.code, 0) << kind << ": " << checked.err;
    EXPECT_EQ(checked.err, "") << kind;
    EXPECT_TRUE(holds(checked.out, "\nok\n")) << kind;
  }
}

// Every line of a scene that has a number with a unit must say what it is: a stranger changes it.
TEST(New, ScenesHaveComments) {
  const test::Place place;
  for (const auto& kind : kinds(place)) {
    ASSERT_EQ(place.reye({"new", "part", "--like", kind, "--out", kind}).code, 0);
    const std::string scene = test::read(place / (kind + "/scene.toml"));
    for (const char* key : {"title ", "geometry ", "wear  ", "fine_zone ", "cycles = ", "jump = ", "depth_mm = "}) {
      const auto at = scene.find(std::string("\n") + key);
      ASSERT_NE(at, scene.npos) << kind << ": " << key;
      EXPECT_TRUE(holds(scene.substr(at + 1, scene.find('\n', at + 1) - at), " # ")) << kind << ": " << key;
    }
  }
}

// Names, kinds and folders that cannot be used must be refused, all at once, and nothing made.
TEST(New, Refusals) {
  const test::Place place;
  place.write("there/file", "mine");
  const auto before = place.files();
  const auto refusal = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "new");
    const auto told = place.reye(words);
    EXPECT_EQ(told.code, 2) << told.out;
    return told.err;
  };
  EXPECT_EQ(refusal({"part", "--like", "baering"}),
            "--like = baering: there is no kind \"baering\"; did you mean \"bearing\"?\n");
  EXPECT_EQ(refusal({"there", "--like", "seal"}),
            "--out = there: it exists already, and nothing is replaced; choose another folder\n");
  const auto both = refusal({"a b", "--like", "x"});
  EXPECT_TRUE(holds(both, "NAME = a b: a name has letters")) << both;
  EXPECT_TRUE(holds(both, "--like = x: there is no kind \"x\"; known: \"ball_on_flat\", ")) << both;
  EXPECT_TRUE(holds(refusal({"part", "--like", "seal", "--out", "no/part"}), "it cannot be made in "));
  for (const char* name : {"../part", ".part", "\"]", "a\nb"})
    EXPECT_TRUE(holds(refusal({name, "--like", "seal"}), "a name has letters")) << name;
  EXPECT_TRUE(holds(refusal({}), "NAME: name your part"));
  EXPECT_EQ(place.files(), before);
}
