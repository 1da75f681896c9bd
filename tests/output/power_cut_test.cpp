#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <map>
#include <random>

#include "output/folder/files.hpp"
#include "output/run/checkpoint.hpp"
#include "output/run/state_archive.hpp"
#include "sample_run.hpp"

using namespace reye::output;

namespace {

/// Bytes that were synced of each file, by inode.
std::map<ino_t, std::uintmax_t> synced;

}  // namespace

/// In the place of the C library's: notes what would survive a power cut.
extern "C" int fsync(int fd) {
  struct stat now {};
  if (::fstat(fd, &now) == 0 && S_ISREG(now.st_mode)) synced[now.st_ino] = static_cast<std::uintmax_t>(now.st_size);
  return 0;
}

namespace {

constexpr int blocks = 12;

/// What a resumed run must leave as an unbroken one does.
std::map<std::string, std::string> results(const std::string& dir) { return sample::contents(dir, {".txt", ".bin"}); }

Checkpoint checkpoint_of(const RunWriter& writer, int block) {
  return {own_origin(state_layout(), "abc123"), writer.counters(), std::to_string(block)};
}

/// Thrown where the power fails.
struct PowerCut {};

/// Plays the blocks from `first` on, a checkpoint after each; the power fails after so many writes.
void play_until_cut(RunWriter& writer, int first, int writes) {
  const auto count = [&] {
    if (writes-- == 0) throw PowerCut();
  };
  for (int block = first; block < blocks; ++block) {
    for (int k = 1; k <= 3; ++k) count(), writer.increment(sample::increment(k, 100.0 * block));
    if (block % 2 == 1) count(), writer.remesh(sample::remesh(100.0 * block));
    if (block % 3 == 0) count(), writer.frame(sample::frame(100.0 * block, 4));
    count();
    save_checkpoint(writer.dir(), checkpoint_of(writer, block + 1));
  }
}

/// Every table ends anywhere between what was synced and what was written.
void cut_power(const std::string& dir, std::mt19937& random) {
  for (const auto& entry : sample::fs::directory_iterator(dir)) {
    if (entry.path().extension() != ".csv") continue;
    struct stat now {};
    ASSERT_EQ(::stat(entry.path().c_str(), &now), 0);
    const auto size = static_cast<std::uintmax_t>(now.st_size), safe = std::min(synced[now.st_ino], size);
    sample::fs::resize_file(entry.path(), safe + random() % (size - safe + 1));
  }
}

}  // namespace

// Wherever the power fails, and wherever the tables then end behind what was synced, the run must resume to the bytes
// of an unbroken one.
TEST(PowerCut, AnyMoment) {
  sample::TemporaryFolder whole;
  RunWriter unbroken(whole.str(), sample::scene());
  unbroken.begin();
  save_checkpoint(whole.str(), checkpoint_of(unbroken, 0));
  play_until_cut(unbroken, 0, -1);
  const auto expected = results(whole.str());
  std::mt19937 random(5);
  for (int moment = 0; moment < 100; ++moment) {
    sample::TemporaryFolder dir;
    RunWriter writer(dir.str(), sample::scene());
    writer.begin();
    save_checkpoint(dir.str(), checkpoint_of(writer, 0));
    int begun = 0;
    for (bool ended = false; !ended;) {
      try {
        play_until_cut(writer, begun, static_cast<int>(random() % 80));
        ended = true;
      } catch (const PowerCut&) {
        cut_power(dir.str(), random);
        const auto search = load_checkpoint(dir.str(), own_origin(state_layout(), "abc123"));
        ASSERT_TRUE(search.found) << "moment " << moment;
        EXPECT_FALSE(search.previous) << "what a checkpoint counts was not synced before it";
        begun = std::stoi(search.found->payload);
        writer = RunWriter(dir.str(), sample::scene());
        writer.resume(search.found->counters);
      }
    }
    ASSERT_EQ(results(dir.str()) == expected, true) << "moment " << moment;
  }
}
