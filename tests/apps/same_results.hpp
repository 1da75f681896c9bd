#pragma once
#include <nlohmann/json.hpp>

#include "apps/command.hpp"

namespace reye::test {

/// All results with times left out: what must not depend on when and how often the program ran.
inline std::map<std::string, std::string> results(const Place& place, const std::string& folder) {
  auto files = place.files(folder);
  for (const char* changing : {"log.txt", "report.html"}) files.erase(changing);
  auto summary = nlohmann::ordered_json::parse(files.at("summary.json"));
  for (const char* time : {"wall_s", "cpu_s", "peak_rss_MB", "room_seconds", "phase_seconds"}) summary.erase(time);
  files["summary.json"] = summary.dump();
  return files;
}

/// Two folders hold the same results.
inline void expect_same(const Place& place, const std::string& one, const std::string& other) {
  const auto a = results(place, one), b = results(place, other);
  for (const auto& [file, bytes] : a) {
    ASSERT_TRUE(b.contains(file)) << file;
    EXPECT_EQ(b.at(file) == bytes, true) << file << " differs";
  }
  EXPECT_EQ(a.size(), b.size());
}

}  // namespace reye::test
