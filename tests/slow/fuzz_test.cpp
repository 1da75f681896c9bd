#include "apps/fuzz.hpp"

using namespace reye;

// Twenty thousand damaged scenes must each be checked or refused with a sentence, none end by a signal, hang or take all
// memory; every hundredth that is sound is run.
TEST(Fuzz, Scenes) { test::expect_ends(test::damaged_scene, 20'000, 100); }

// The same of five thousand damaged geometry files.
TEST(Fuzz, GeometryFiles) { test::expect_ends(test::damaged_geometry, 5'000, 100); }

// Files that keep their readers busy for ever must be refused, within a minute.
TEST(Fuzz, EndlessFiles) {
  for (const char* file : {"endless.brep", "endless.vtu"}) {
    test::Trial trial = test::damaged_geometry(0);
    const std::string name = std::string("blocks") + test::fs::path(file).extension().string();
    const std::string sound = trial.what;
    trial.files["scene.toml"] = test::changed(trial.files["scene.toml"], {{sound, name}});
    trial.files[name] = test::shared(std::string("tests/cad/data/broken/") + file);
    test::expect_an_end(trial, 0, false);
  }
}
