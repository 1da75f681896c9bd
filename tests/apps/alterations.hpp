#pragma once
#include <limits>
#include <random>

#include "apps/command.hpp"
#include "apps/same_results.hpp"
#include "apps/scenes.hpp"
#include "apps/solid_scenes.hpp"
#include "output/folder/files.hpp"
#include "output/run/checkpoint.hpp"
#include "output/run/state_archive.hpp"
#include "output/solid/solid_archive.hpp"

/// Checkpoints that were altered and sealed again with the right checksum.
namespace reye::test {

/// Some bytes of it replaced: any value, or eight by NaN, by a number that is too large, or by an invalid size.
inline std::string altered(std::string bytes, std::mt19937& random) {
  constexpr double numbers[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                1e308, -1.0, 0.0};
  constexpr std::int64_t sizes[] = {-1, 0, 1, 1LL << 31, 1LL << 40, std::numeric_limits<std::int64_t>::max()};
  for (int n = 1 + static_cast<int>(random() % 3); n > 0; --n) {
    const std::size_t at = random() % (bytes.size() - 8);
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        std::memcpy(&bytes[at], &numbers[random() % 5], 8);
        break;
      case 2:
        std::memcpy(&bytes[at], &sizes[random() % 6], 8);
        break;
      default:
        bytes.erase(at, 1 + random() % 16);
    }
  }
  return bytes;
}

/// A run that is interrupted once its history has more than so many rows.
struct Interrupted {
  std::string geometry_file, geometry, scene;
  long rows = 0;
  std::uint64_t layout = 0;  ///< of its states
};

inline Interrupted wearing_interrupted() { return {"wearing.geo", wearing_geo, wearing, 40, output::state_layout()}; }
inline Interrupted rubbing_interrupted() {
  return {"rubbing.geo", rubbing_geo, rubbing, 15, output::solid_state_layout()};
}

/// A run is interrupted in the middle; its checkpoint is altered so many times, and the run resumed each time. That
/// must end with a code of the contract and without NaN in its summary; in one that is refused, with a
/// sentence that names the file.
inline void expect_sentences(const Interrupted& of, int alterations) {
  const Place place;
  place.write(of.geometry_file, of.geometry);
  place.write("scene.toml", of.scene);
  auto run = place.start_reye({"run", "scene.toml", "--out", "o", "--quiet"});
  ASSERT_TRUE(run.signal_when(SIGINT, [&] { return lines(place / "o/history.csv") > of.rows; }));
  ASSERT_EQ(run.wait().code, 130);
  fs::remove(place / "o/checkpoint/previous.bin");
  const auto whole = output::unpacked(read(place / "o/checkpoint/current.bin"), of.layout);
  std::mt19937 random(7);
  int refused = 0;
  for (int k = 0; k < alterations; ++k) {
    fs::remove_all(place / "again");
    fs::copy(place / "o", place / "again", fs::copy_options::recursive);
    auto checkpoint = whole;
    checkpoint.payload = altered(whole.payload, random);
    output::atomic_write((place / "again/checkpoint/current.bin").string(), output::packed(checkpoint));
    const auto told = place
                          .start({"/usr/bin/timeout", "60", REYE_COMMAND, "run", "scene.toml", "--out", "again",
                                  "--restart", "--quiet"})
                          .wait();
    ASSERT_TRUE(told.code == 0 || told.code == 1 || told.code == 2)
        << "alteration " << k << ": " << told.code << ' ' << told.err;
    refused += told.code == 2;
    const std::string sentence = "--restart = again: no checkpoint to resume from: again/checkpoint/current.bin: ";
    ASSERT_TRUE(told.code != 2 || holds(told.err, sentence)) << told.err;
    ASSERT_TRUE(told.code != 1 || !told.err.empty());
  }
  EXPECT_GT(refused, alterations / 3);
}

}  // namespace reye::test
