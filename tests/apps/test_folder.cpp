#include "command.hpp"
#include "places.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

/// The two blocks under two loads.
struct TwoScenes : test::WithBlocks {
  TwoScenes() { write("other.toml", test::changed(test::blocks, {{"-20.0", "-30.0"}})); }
};

}  // namespace

// A folder with another scene's run, or with results of unknown origin, must be refused untouched unless --force.
TEST(Folder, AnotherRun) {
  const TwoScenes place;
  ASSERT_EQ(place.reye({"run", "blocks.toml", "--out", "o", "--quiet"}).code, 0);
  const auto before = place.files("o");
  const auto refused = place.reye({"run", "other.toml", "--out", "o"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(
      refused.err,
      "--out = o: the output folder o holds the run of another scene, 'blocks'; choose another folder with --out, or "
      "replace it with --force\n");
  EXPECT_EQ(place.files("o"), before);
  EXPECT_EQ(place.reye({"run", "other.toml", "--out", "o", "--quiet", "--force"}).code, 0);
  EXPECT_TRUE(test::holds(test::read(place / "o/.reye.json"), "other"));
  place.write("unknown/history.csv", "step,cycle\n");
  EXPECT_EQ(place.reye({"run", "blocks.toml", "--out", "unknown"}).code, 2);
}

// Results of the same scene must stay whole until a new run of it starts: bad input leaves them alone.
TEST(Folder, ReplacedOnlyByAGoodStart) {
  const TwoScenes place;
  ASSERT_EQ(place.reye({"run", "blocks.toml", "--out", "o", "--quiet"}).code, 0);
  place.write("o/notes.txt", "mine");
  const auto before = place.files("o");
  place.write("blocks.toml", test::changed(test::blocks, {{R"(["base_top"])", R"(["base_to"])"}}));
  EXPECT_EQ(place.reye({"run", "blocks.toml", "--out", "o", "--force"}).code, 2);
  EXPECT_EQ(place.files("o"), before);
  place.write("blocks.toml", test::blocks);
  EXPECT_EQ(place.reye({"run", "blocks.toml", "--out", "o", "--quiet"}).code, 0);
  EXPECT_EQ(test::read(place / "o/notes.txt"), "mine");
}

// A folder that cannot be made must be refused as bad input.
TEST(Folder, CannotBeMade) {
  const TwoScenes place;
  place.write("file", "");
  const auto in_a_file = place.reye({"run", "blocks.toml", "--out", "file/o"});
  EXPECT_EQ(in_a_file.code, 2);
  EXPECT_TRUE(in_a_file.err.starts_with("--out = file/o: cannot make the output folder file/o in /")) << in_a_file.err;
  EXPECT_EQ(place.reye({"run", "blocks.toml", "--out", "file"}).err,
            "--out = file: the output folder file is a file\n");
}

// A disk that refuses in the middle of a run must end it with 1 and a message that names the file.
TEST(Folder, DiskRefuses) {
  const TwoScenes place;
  const std::string limited =
      "trap '' XFSZ; ulimit -f 4; exec \"$0\" run blocks.toml --out o --quiet";  // blocks of 1 KB
  const auto told = place.start({"/bin/bash", "-c", limited, REYE_COMMAND}).wait();
  EXPECT_EQ(told.code, 1) << told.err;
  EXPECT_TRUE(told.err.starts_with("reye: cannot write o/")) << told.err;
  EXPECT_TRUE(test::holds(told.err, "File too large")) << told.err;
  EXPECT_FALSE(test::fs::exists(place / "o/summary.json"));
}
