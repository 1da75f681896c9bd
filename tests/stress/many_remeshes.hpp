#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "apps/command.hpp"
#include "apps/scenes.hpp"
#include "mesh/quality.hpp"
#include "scene/read.hpp"
#include "sim/measure/measure.hpp"
#include "sim/study/prepare.hpp"
#include "sim/study/run.hpp"
#include "support/sanitizers.hpp"
#include "support/temporary_folder.hpp"

/// Many remeshes in a row.
namespace reye::test {

inline double resident_MB() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// Two wearing bodies, each remeshed once a cycle.
inline sim::Problem remeshed_each_cycle(int cycles) {
  const std::filesystem::path folder(support::temporary_folder());
  std::ofstream(folder / "wearing.geo") << wearing_geo;
  std::ofstream(folder / "pin.toml") << changed(
      worn_pin, {{"cycles = 6", "cycles = " + std::to_string(cycles)}, {"1.0e-4", "1.0e-6"}, {"1.0e-5", "0.5e-6"}});
  return sim::prepare(scene::read((folder / "pin.toml").string()));
}

/// Two wearing bodies remeshed so many times each lose exactly what their ledger says, keep sound meshes of bounded
/// size, and need no more memory at the end than after the first fifth.
inline void expect_sound_remeshes(int each) {
  const auto p = remeshed_each_cycle(each);
  auto state = sim::initial_state(p);
  double early = 0.0;
  int most_nodes = 0;
  double poorest = 1.0;
  sim::Observer watch;
  watch.remesh = [&](const sim::RemeshRecord& r) {
    most_nodes = std::max(most_nodes, r.nodes_after);
    poorest = std::min(poorest, r.scaled_jacobian_after);
  };
  watch.block = [&](const sim::State& s) {
    if (s.counts.remeshes == 2 * each / 5) early = resident_MB();
  };
  const auto summary = sim::run(p, state, watch);
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_GE(summary.counts.remeshes, 2 * each);
  EXPECT_LT(summary.contacts[0].ledger_relative_error.value(), 1e-9);
  EXPECT_GT(summary.contacts[0].secondary.worn_area, 0.0);
  EXPECT_GT(poorest, 0.3);
  EXPECT_LT(most_nodes, 2 * p.shapes[0]->mesh.node_count());
  EXPECT_LT(resident_MB() - early, support::address_sanitizer ? 300.0 : 8.0);
}

}  // namespace reye::test
