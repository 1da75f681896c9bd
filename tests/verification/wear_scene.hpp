#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "scene/read.hpp"
#include "sim/study/prepare.hpp"
#include "sim/study/run.hpp"
#include "support/temporary_folder.hpp"

/// Scenes of geo/ with a few words replaced, played through the whole program but for its output.
namespace reye::verification {

using Replacements = std::vector<std::pair<std::string, std::string>>;

inline Replacements operator+(Replacements a, const Replacements& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline std::string number(double x) { return std::to_string(x); }

/// A run that has ended.
struct Played {
  sim::Problem problem;
  sim::State state;
  sim::Summary summary;
  std::vector<sim::IncrementRecord> records;
  sim::Frame frame;  ///< the last one

  const sim::ContactSummary& contact() const { return summary.contacts.at(0); }
  const sim::SurfaceRecord& surface(sim::Side side) const {
    return frame.surfaces.at(side == sim::Side::secondary ? 0 : 1);
  }
};

inline std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Every replacement must find its words, so that no variant is silently the scene itself.
inline std::string replaced(std::string text, const Replacements& replacements) {
  for (const auto& [from, to] : replacements) {
    auto at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("the scene does not say: " + from);
    for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  }
  return text;
}

/// The text of geo/<name>/scene.toml with its geometry's paths made absolute.
inline std::string scene_text(const std::string& name, const Replacements& replacements = {}) {
  const std::string folder = std::string(REYE_SOURCE_DIR) + "/geo/" + name + "/";
  std::string text = replaced(read_text(folder + "scene.toml"), replacements);
  return replaced(text, {{"geometry = [\"", "geometry = [\"" + folder}});
}

inline sim::Problem prepared(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string("reye_") + test->test_suite_name() + "_" + test->name() + ".toml";
  std::replace(name.begin(), name.end(), '/', '_');  // of parametrised tests
  const std::string path = support::temporary_folder() + name;
  std::ofstream(path, std::ios::binary) << text;
  return sim::prepare(scene::read(path));
}

inline Played played(const std::string& text) {
  Played p;
  p.problem = prepared(text);
  p.state = sim::initial_state(p.problem);
  sim::Observer watch;
  watch.increment = [&](const sim::IncrementRecord& r) { p.records.push_back(r); };
  watch.frame = [&](const sim::Frame& f) { p.frame = f; };
  p.summary = sim::run(p.problem, p.state, watch);
  EXPECT_EQ(p.summary.status, sim::RunStatus::done) << p.summary.reason;
  return p;
}

/// Largest |value - expected| / expected.
inline double worst(const std::vector<double>& values, double expected) {
  double w = values.empty() ? 1e300 : 0.0;
  for (double v : values) w = std::max(w, std::abs(v / expected - 1.0));
  return w;
}

}  // namespace reye::verification
