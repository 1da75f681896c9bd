#include "stress/many_remeshes.hpp"

// A hundred remeshes of each of two wearing bodies must neither lose volume nor spoil meshes nor gather memory; the
// slow test of this name makes a thousand in all.
TEST(Remesh, ManyTimes) { reye::test::expect_sound_remeshes(100); }
