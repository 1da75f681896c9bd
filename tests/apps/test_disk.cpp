#include "command.hpp"
#include "places.hpp"
#include "same_results.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

/// The two blocks worn through fifty blocks of cycles: a history longer than a checkpoint.
struct WornBlocks : test::WithBlocks {
  WornBlocks()
      : WithBlocks(std::string(test::blocks) +
                   "[[step]]\nname = \"wear\"\nincrements = 6\ncycles = 50\n[output]\ncheckpoint_s = 0\n") {}
};

}  // namespace

// A disk that takes no more must end the run with 1 and the reason, its last checkpoint whole: with space again it
// resumes to the bytes of an unbroken run.
TEST(Disk, FullInTheMiddle) {
  const WornBlocks place;
  ASSERT_EQ(place.reye({"run", "blocks.toml", "--out", "whole", "--quiet"}).code, 0);
  const auto checkpoint = test::fs::file_size(place / "whole/checkpoint/current.bin");
  const auto history = test::fs::file_size(place / "whole/history.csv");
  ASSERT_GT(history, checkpoint + 4096) << "the history is to be what finds the disk full";
  const auto told = place.reye({"run", "blocks.toml", "--out", "o", "--quiet"}, (checkpoint + history) / 2);
  EXPECT_EQ(told.code, 1);
  EXPECT_EQ(
      told.err,
      "reye: cannot write o/history.csv: File too large; the last checkpoint is intact: --restart resumes from it\n");
  EXPECT_FALSE(test::fs::exists(place / "o/summary.json"));
  const auto again = place.reye({"run", "blocks.toml", "--out", "o", "--restart", "--quiet"});
  EXPECT_EQ(again.code, 0) << again.err;
  test::expect_same(place, "whole", "o");
}

// When not even the first files find room, the run must end with 1, say which could not be written and leave a folder
// that a new run takes: the picture of the scene comes first, the checkpoint after it.
TEST(Disk, FullFromTheStart) {
  const test::WithWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  const auto picture = test::fs::file_size(place / "whole/scene.svg");
  const std::vector<std::pair<std::string, std::uintmax_t>> rooms = {{"scene.svg", picture - 100},
                                                                     {"checkpoint/fresh.bin", picture + 100}};
  for (const auto& [file, bytes] : rooms) {
    const auto told = place.reye({"run", "wearing.toml", "--out", "o", "--quiet"}, bytes);
    EXPECT_EQ(told.code, 1);
    EXPECT_EQ(told.err, "reye: cannot write o/" + file + ": File too large\n");
    EXPECT_FALSE(test::fs::exists(place / "o" / file));
  }
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "o", "--quiet"}).code, 0);
  test::expect_same(place, "whole", "o");
}

// A checkpoint that finds no room must leave the one before it whole and nothing half written.
TEST(Disk, FullAtACheckpoint) {
  const WornBlocks place;
  ASSERT_EQ(place.reye({"run", "blocks.toml", "--out", "whole", "--quiet"}).code, 0);
  auto run = place.start_reye({"run", "blocks.toml", "--out", "o", "--quiet"});
  ASSERT_TRUE(run.signal_when(SIGINT, [&] { return test::lines(place / "o/history.csv") > 20; }));
  ASSERT_EQ(run.wait().code, 130);
  const auto before = test::read(place / "o/checkpoint/current.bin");
  ASSERT_GT(before.size(), test::fs::file_size(place / "o/history.csv") + 1000)
      << "the checkpoint is to be what finds the disk full";
  const auto told = place.reye({"run", "blocks.toml", "--out", "o", "--restart", "--quiet"}, before.size() - 100);
  EXPECT_EQ(told.code, 1);
  EXPECT_EQ(told.err,
            "reye: cannot write o/checkpoint/fresh.bin: File too large; the last checkpoint is intact: --restart "
            "resumes from it\n");
  EXPECT_EQ(test::read(place / "o/checkpoint/current.bin"), before);
  EXPECT_FALSE(test::fs::exists(place / "o/checkpoint/fresh.bin"));
  ASSERT_EQ(place.reye({"run", "blocks.toml", "--out", "o", "--restart", "--quiet"}).code, 0);
  test::expect_same(place, "whole", "o");
}
