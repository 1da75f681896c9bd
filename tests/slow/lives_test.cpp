#include "apps/alterations.hpp"
#include "apps/kills.hpp"
#include "apps/long_life.hpp"

using namespace reye;

// A run of a hundred thousand blocks must need no more memory than one of a thousand, and less disk than its stated
// bound.
TEST(Lives, HundredThousandBlocks) { test::expect_bounded(100000); }

// A run with friction, wear, plastic flow and fresh meshes that is killed two hundred times must end as the unbroken
// one.
TEST(Lives, TwoHundredKills) { test::expect_survival(test::yielding_contact(), 200); }

// A run whose tables end anywhere behind the checkpoint before the last, two hundred times, must end as the
// unbroken one.
TEST(Lives, TwoHundredPowerCuts) { test::expect_survival(test::yielding_contact(), 200, true); }

// A run of solids that is killed twenty times, and another one whose tables then end anywhere behind the checkpoint
// before the last, must end as the unbroken one.
TEST(Lives, TwentyKillsOfSolids) {
  test::expect_survival(test::rubbing_solids(), 20);
  test::expect_survival(test::rubbing_solids(), 20, true);
}

// A checkpoint that was altered under a right checksum in two hundred ways must be refused with a sentence or resumed
// from.
TEST(Lives, TwoHundredAlteredCheckpoints) {
  test::expect_sentences(test::wearing_interrupted(), 200);
  test::expect_sentences(test::rubbing_interrupted(), 200);
}
