#include "stress/many_remeshes.hpp"

// Five hundred remeshes of each of two wearing bodies must neither lose volume nor spoil meshes nor gather memory.
TEST(Remesh, ManyTimes) { reye::test::expect_sound_remeshes(500); }
