#include "apps/fuzz.hpp"

using namespace reye;

// A scene with damaged text must be checked or refused with a sentence, never end by a signal, hang or take all memory.
TEST(Fuzz, Scenes) { test::expect_ends(test::damaged_scene, 0, 250, 25); }

// Damaged geometry files must be read or refused.
TEST(Fuzz, GeometryFiles) { test::expect_ends(test::damaged_geometry, 0, 50, 20); }
