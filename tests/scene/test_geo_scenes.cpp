#include <gtest/gtest.h>

#include <filesystem>

#include "base/errors.hpp"
#include "scene/read.hpp"

using namespace reye;
namespace fs = std::filesystem;

/// Every scene of the repository reads without error or warning.
TEST(GeoScenes, AllRead) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(REYE_SOURCE_DIR) / "geo")) {
    const auto file = entry.path() / "scene.toml";
    if (!fs::exists(file)) continue;
    ++count;
    try {
      const auto scene = scene::read(file.string());
      EXPECT_EQ(scene.name, entry.path().filename().string());
      EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
    } catch (const base::InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GE(count, 9);
}
