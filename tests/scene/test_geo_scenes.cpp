#include <gtest/gtest.h>

#include <filesystem>

#include "base/errors.hpp"
#include "scene/read.hpp"
#include "scene/solid/solid_scene.hpp"

using namespace reye;
namespace fs = std::filesystem;

/// Every scene of the repository reads without error or warning.
TEST(GeoScenes, AllRead) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(REYE_SOURCE_DIR) / "geo")) {
    const auto file = entry.path() / "scene.toml";
    if (!fs::exists(file)) continue;
    ++count;
    const auto expect_sound = [&](const auto& scene) {
      EXPECT_EQ(scene.name, entry.path().filename().string());
      EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
    };
    try {
      if (scene::is_solid(file.string()))
        expect_sound(scene::read_solid(file.string()));
      else
        expect_sound(scene::read(file.string()));
    } catch (const base::InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GE(count, 9);
}
