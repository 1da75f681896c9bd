#include "apps/fuzz.hpp"

using namespace reye;

namespace {

/// The seeds in blocks, each a test, so that several run beside one another.
class Seeds : public testing::TestWithParam<unsigned> {};

// Twenty thousand damaged scenes must each be checked or refused with a sentence, none end by a signal, hang or take
// all memory; every hundredth that is sound is run.
TEST_P(Seeds, Scenes) { test::expect_ends(test::damaged_scene, 2000 * GetParam(), 2000, 100); }

// Five thousand damaged geometry files must each be read or refused.
TEST_P(Seeds, GeometryFiles) { test::expect_ends(test::damaged_geometry, 500 * GetParam(), 500, 100); }

INSTANTIATE_TEST_SUITE_P(Fuzz, Seeds, testing::Range(0U, 10U));

}  // namespace

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
