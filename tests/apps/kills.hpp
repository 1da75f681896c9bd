#pragma once
#include <chrono>
#include <random>

#include "apps/command.hpp"
#include "apps/same_results.hpp"
#include "apps/scenes.hpp"
#include "apps/solid_scenes.hpp"
#include "output/folder/tables.hpp"
#include "output/run/checkpoint.hpp"
#include "output/run/state_archive.hpp"
#include "output/solid/solid_archive.hpp"

/// A run that is killed again and again.
namespace reye::test {

/// The wearing contact on steel that yields under the load: friction, wear, plastic flow and, twice, fresh meshes.
inline std::string yielding() {
  const std::string steel = "[material.steel]\nE_MPa = 200e3\nnu    = 0.3\n";
  return changed(
             wearing,
             {{"[body.disc]\n", "[body.disc]\nkinematics = \"small\"\n"},
              {"[body.flat]\n", "[body.flat]\nkinematics = \"small\"\n"},
              {steel,
               steel +
                   "law = \"hencky_j2\"\nhardening = { law = \"linear\", yield_MPa = 480.0, modulus_MPa = 2000.0 }\n"},
              {"half_width_mm = 0.08, depth_mm = 0.02, size_mm = 0.008",
               "half_width_mm = 0.08, depth_mm = 0.04, size_mm = 0.008"},
              {"increments = 16\ncycles = 400\njump = 100", "increments = 8\ncycles = 240\njump = 20"},
              {"every_cycles = 200 }", "every_cycles = 40, at_remeshes = true }"}}) +
         "[remesh]\nevery_blocks = 6\n";
}

/// A run that is to be killed.
struct Victim {
  std::string geometry_file, geometry, scene;
  std::uint64_t layout = 0;  ///< of its states
};

inline Victim yielding_contact() { return {"wearing.geo", wearing_geo, yielding(), output::state_layout()}; }
inline Victim rubbing_solids() { return {"rubbing.geo", rubbing_geo, rubbing, output::solid_state_layout()}; }
inline Victim worn_solids() { return {"rubbing.geo", rubbing_geo, worn_rubbing(), output::solid_state_layout()}; }

/// Rows that a checkpoint counts, by table; empty where it is not there.
inline std::map<std::string, long> rows_in(const fs::path& checkpoint, std::uint64_t layout) {
  if (!fs::exists(checkpoint)) return {};
  const auto counters = output::unpacked(read(checkpoint), layout).counters;
  auto rows = counters.surface_rows;
  rows["history.csv"] = counters.history_rows;
  if (counters.remesh_rows > 0) rows["remesh.csv"] = counters.remesh_rows;
  return rows;
}

/// Ends every table at any byte behind the rows that the older checkpoint counts, as after a power cut on a disk that
/// kept less than it promised.
inline void cut_tables(const fs::path& folder, std::uint64_t layout, std::mt19937& random) {
  auto safe = rows_in(folder / "checkpoint/previous.bin", layout);
  if (safe.empty()) safe = rows_in(folder / "checkpoint/current.bin", layout);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    const auto found = safe.find(entry.path().filename().string());
    const auto least = found == safe.end() ? 0 : output::size_of_rows(entry.path().string(), found->second);
    fs::resize_file(entry.path(), least + random() % (fs::file_size(entry.path()) - least + 1));
  }
}

/// Kills a run at random moments, every other time just after a frame was begun, when much is being written; restarts
/// it each time, until it ends; and so on until so many kills have been survived. Each must end as the unbroken run
/// does. With `power_cuts` each kill cuts the tables, too.
inline void expect_survival(const Victim& victim, int kills, bool power_cuts = false) {
  using clock = std::chrono::steady_clock;
  const Place place;
  place.write(victim.geometry_file, victim.geometry);
  place.write("scene.toml", victim.scene);
  const auto begun = clock::now();
  const auto whole = place.reye({"run", "scene.toml", "--out", "whole", "--quiet"});
  ASSERT_EQ(whole.code, 0) << whole.err;
  const double seconds = std::chrono::duration<double>(clock::now() - begun).count();
  std::mt19937 random(20);
  std::exponential_distribution<double> wait(10.0 / seconds);
  std::uniform_real_distribution<double> moment(0.0, 0.02);
  const auto frames_changed = [&] {
    std::error_code none;
    return fs::last_write_time(place / "broken/frames", none);
  };
  for (int killed = 0, runs = 0; killed < kills; ++runs) {
    fs::remove_all(place / "broken");
    for (bool ended = false; !ended;) {
      std::vector<std::string> words{"run", "scene.toml", "--out", "broken", "--quiet"};
      if (fs::exists(place / "broken/checkpoint/current.bin") || fs::exists(place / "broken/checkpoint/previous.bin"))
        words.push_back("--restart");
      auto run = place.start_reye(words);
      if (killed < kills) {
        const auto since = frames_changed();
        auto at = clock::now() + std::chrono::duration<double>(wait(random));
        bool waits_for_frame = killed % 2 == 1;
        run.signal_when(SIGKILL, [&] {
          if (clock::now() < at) return false;
          if (!waits_for_frame) return true;
          if (frames_changed() == since) return false;
          waits_for_frame = false;
          at = clock::now() + std::chrono::duration<double>(moment(random));
          return false;
        });
      }
      const auto told = run.wait();
      ended = told.code != 128 + SIGKILL;
      killed += !ended;
      if (!ended && power_cuts && fs::exists(place / "broken/checkpoint"))
        cut_tables(place / "broken", victim.layout, random);
      ASSERT_TRUE(!ended || told.code == 0) << told.err;
    }
    expect_same(place, "whole", "broken");
    if (testing::Test::HasFailure()) FAIL() << "in run " << runs << ", after " << killed << " kills";
  }
}

}  // namespace reye::test
