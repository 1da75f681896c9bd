#include <nlohmann/json.hpp>

#include "command.hpp"
#include "output/run/checkpoint.hpp"
#include "output/run/state_archive.hpp"
#include "places.hpp"
#include "same_results.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

std::string status(const test::Place& place, const std::string& folder) {
  return nlohmann::json::parse(test::read(place / (folder + "/summary.json"))).at("status");
}

/// Runs until the history has so many rows, then sends a signal; the run must not have ended by itself.
test::Told interrupted(const test::Place& place, const std::string& folder, long rows,
                       std::vector<std::string> more = {}, int signal = SIGINT) {
  std::vector<std::string> words{"run", "wearing.toml", "--out", folder};
  words.insert(words.end(), more.begin(), more.end());
  auto run = place.start_reye(words);
  EXPECT_TRUE(run.signal_when(signal, [&] { return test::lines(place / (folder + "/history.csv")) > rows; }));
  return run.wait();
}

}  // namespace

// Two runs of a scene must give the same bytes.
TEST(Restart, TwoRunsAreTheSame) {
  const test::WithWearing place;
  for (const char* folder : {"a", "b"})
    ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", folder, "--quiet"}).code, 0);
  test::expect_same(place, "a", "b");
}

// Ctrl-C must finish the increment, write everything and end with 130.
TEST(Restart, InterruptWritesAll) {
  const test::WithWearing place;
  const auto told = interrupted(place, "o", 25);
  EXPECT_EQ(told.code, 130) << told.err;
  EXPECT_TRUE(test::holds(told.err, "reye: interrupted in step \"wear\" at cycle "));
  EXPECT_EQ(status(place, "o"), "interrupted");
  const auto history = test::read(place / "o/history.csv");
  EXPECT_EQ(history.back(), '\n');
  EXPECT_LT(test::lines(place / "o/history.csv"), 67);
  for (const char* file : {"report.html", "series.pvd", "surface_pad_secondary.csv", "checkpoint/current.bin"})
    EXPECT_TRUE(test::fs::exists(place / "o" / file)) << file;
}

// A run that was interrupted after its first block of cycles and resumed must leave the bytes of an unbroken one.
TEST(Restart, SameBytesAsUnbroken) {
  const test::WithWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  ASSERT_EQ(interrupted(place, "broken", 22).code, 130);
  const auto told = place.reye({"run", "wearing.toml", "--out", "broken", "--restart"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(status(place, "broken"), "done");
  test::expect_same(place, "whole", "broken");
}

// Interrupted in the very first step and again later: still the same bytes.
TEST(Restart, SeveralInterruptions) {
  const test::WithWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  ASSERT_EQ(interrupted(place, "broken", 1).code, 130);
  ASSERT_EQ(interrupted(place, "broken", 30, {"--restart"}).code, 130);
  ASSERT_EQ(interrupted(place, "broken", 45, {"--restart"}).code, 130);
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "broken", "--restart", "--quiet"}).code, 0);
  test::expect_same(place, "whole", "broken");
}

// A run killed without warning must resume from its last checkpoint to the same bytes.
TEST(Restart, Killed) {
  const test::WithWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  for (const long rows : {1L, 21L, 40L}) {
    test::fs::remove_all(place / "broken");
    EXPECT_EQ(interrupted(place, "broken", rows, {}, SIGKILL).code, 128 + SIGKILL);
    EXPECT_FALSE(test::fs::exists(place / "broken/summary.json"));
    ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "broken", "--restart", "--quiet"}).code, 0);
    test::expect_same(place, "whole", "broken");
  }
}

// Interrupted or killed between blocks in which both bodies are remeshed, with wider zones and other facets, a run
// must resume to the bytes of the unbroken one.
TEST(Restart, AcrossARemesh) {
  const test::WithWearing place;
  place.write("wearing.toml", test::worn_pin);
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  EXPECT_GT(test::lines(place / "whole/remesh.csv"), 6);
  for (const int signal : {SIGINT, SIGKILL})
    for (const long rows : {4L, 6L}) {
      test::fs::remove_all(place / "broken");
      EXPECT_EQ(interrupted(place, "broken", rows, {}, signal).code, signal == SIGINT ? 130 : 128 + SIGKILL);
      ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "broken", "--restart", "--quiet"}).code, 0);
      test::expect_same(place, "whole", "broken");
    }
}

// With checkpoints rarer than the run is long, an interrupted run must still keep its last block end, a killed one only
// its start; both must resume to the bytes of the unbroken run.
TEST(Restart, RareCheckpoints) {
  const test::WithWearing place;
  place.write("wearing.toml", test::changed(test::wearing, {{"checkpoint_s = 0", "checkpoint_s = 1e6"}}));
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  const auto rows = [&](const std::string& folder) {
    const auto file = nlohmann::json::parse(test::read(place / (folder + "/.reye.json")));
    const auto search = output::load_checkpoint((place / folder).string(),
                                                output::own_origin(output::state_layout(), file.at("scene_sha256")));
    return search.found ? search.found->counters.history_rows : -1;
  };
  EXPECT_EQ(rows("whole"), 66);
  for (const int signal : {SIGINT, SIGKILL}) {
    test::fs::remove_all(place / "broken");
    EXPECT_EQ(interrupted(place, "broken", 22, {}, signal).code, signal == SIGINT ? 130 : 128 + SIGKILL);
    if (signal == SIGKILL)
      EXPECT_EQ(rows("broken"), 0);
    else
      EXPECT_GE(rows("broken"), 18);
    ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "broken", "--restart", "--quiet"}).code, 0);
    for (const char* folder : {"whole", "broken"})  // how old the checkpoint before the last is depends on the clock
      test::fs::remove(place / folder / "checkpoint/previous.bin");
    test::expect_same(place, "whole", "broken");
  }
}

// A restart without a checkpoint, or with one of another scene, must be refused and write nothing.
TEST(Restart, NothingToGoOnFrom) {
  const test::WithWearing place;
  const auto told = place.reye({"run", "wearing.toml", "--out", "o", "--restart"});
  EXPECT_EQ(told.code, 2);
  EXPECT_TRUE(test::holds(told.err, "--restart = o: no checkpoint to resume from: o/checkpoint/current.bin: missing; "))
      << told.err;
  EXPECT_FALSE(test::fs::exists(place / "o"));
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "o", "--quiet"}).code, 0);
  place.write("wearing.toml", test::changed(test::wearing, {{"friction  = 0.5", "friction  = 0.4"}}));
  test::fs::copy(place / "wearing.toml", place / "another.toml");
  const auto before = place.files("o");
  const auto other = place.reye({"run", "another.toml", "--out", "o", "--restart", "--force"});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(test::holds(other.err, "of another scene"));
  EXPECT_EQ(place.files("o"), before);
}
