#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/command.hpp"
#include "apps/scenes.hpp"

/// A life of very many blocks: two small blocks, one rubbing on the other to and fro, two increments a cycle. Remeshes
/// by blocks, of which none comes due, let the outlines wait for no wear: they move after every block.
namespace reye::test {

inline std::string long_life(long count) {
  auto text = changed(blocks, {{"x        = \"fixed\"", "x        = { motion_mm = 0.01, history = \"stroke\" }"},
                               {"3.0e-5", "3.0e-9"},
                               {"2.0e-5", "2.0e-9"},
                               {"press = [[0.0, 0.0], [1.0, 1.0]]",
                                "press = [[0.0, 0.0], [1.0, 1.0]]\nstroke = [[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]]"}});
  return text + "[[step]]\nname = \"wear\"\nplay = [\"stroke\"]\ncycles = " + std::to_string(count) +
         "\n[output]\nframes = { per_decade = 4 }\nhistory = { every_blocks = " + std::to_string(count / 100) +
         " }\ncheckpoint_s = 1\n[remesh]\nevery_blocks = " + std::to_string(10 * count) + "\n";
}

struct Life {
  Told told;
  std::map<std::string, std::string> files;
  nlohmann::json summary;

  double folder_bytes() const {
    double sum = 0.0;
    for (const auto& [name, bytes] : files) sum += static_cast<double>(bytes.size());
    return sum;
  }
  std::size_t largest(const std::string& beginning) const {
    std::size_t size = 0;
    for (const auto& [name, bytes] : files)
      if (name.rfind(beginning, 0) == 0) size = std::max(size, bytes.size());
    return size;
  }
};

inline Life lived(const Place& place, long count) {
  place.write("blocks.geo", blocks_geo);
  const std::string name = "life" + std::to_string(count);
  place.write(name + ".toml", long_life(count));
  Life life{place.reye({"run", name + ".toml", "--out", name, "--quiet"}), place.files(name), {}};
  EXPECT_EQ(life.told.code, 0) << life.told.err;
  life.summary = nlohmann::json::parse(life.files.at("summary.json"));
  return life;
}

/// The bound that src/output/README.md states, for a run without remeshes and cut-backs.
inline double folder_bound(const Life& life, double frames, double surface_nodes, double rows, double columns) {
  const auto frame = static_cast<double>(life.largest("frames/bodies_") + life.largest("frames/surface_"));
  return frames * (frame + 220.0 * surface_nodes + 200.0) + 26.0 * columns * rows +
         2.0 * static_cast<double>(life.largest("checkpoint/")) + 5e6;
}

/// A life of so many blocks must need no more memory than one of a thousand, and no more disk than the bound says.
inline void expect_bounded(long count) {
  const Place place;
  const Life early = lived(place, 1000), late = lived(place, count);
  EXPECT_EQ(late.summary.at("cycles").get<double>(), count);
  EXPECT_EQ(late.summary.at("counts").at("blocks").get<double>(), count + 1);
  constexpr double scatter_MB = 8.0;  // the peaks of one and the same run were 74.2 to 78.6 MB
  EXPECT_LT(late.told.peak_MB, early.told.peak_MB + scatter_MB);
  const double frames =
      4.0 * std::log10(static_cast<double>(count)) + 4.0;  // 4 a decade, start, load step, first block, end
  const double rows = 1.0 + 2.0 * 102.0;                   // load step, every hundredth, first and last
  const auto history = "life" + std::to_string(count) + "/history.csv";
  EXPECT_LE(lines(place / history), static_cast<long>(rows) + 1);
  EXPECT_LT(late.folder_bytes(), folder_bound(late, frames, 5.0 + 9.0, rows, 12.0));
  EXPECT_LT(late.folder_bytes(), 2e6);
  EXPECT_LT(late.largest("checkpoint/"), early.largest("checkpoint/") + 1000);
  std::printf("%ld blocks: %.1f MB of memory (1000 blocks: %.1f), %.0f kB on disk (bound %.0f), %.0f s\n", count,
              late.told.peak_MB, early.told.peak_MB, 1e-3 * late.folder_bytes(),
              1e-3 * folder_bound(late, frames, 14.0, rows, 12.0), late.summary.at("wall_s").get<double>());
}

}  // namespace reye::test
