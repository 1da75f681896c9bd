#include "apps/kills.hpp"
#include "apps/long_life.hpp"

using namespace reye;

// A run of two thousand blocks must need no more memory than one of a thousand, and less disk than its stated bound.
TEST(Lives, TwoThousandBlocks) { test::expect_bounded(2000); }

// A run with friction, wear, plastic flow and fresh meshes that is killed five times, its tables then ending anywhere
// behind the checkpoint before the last, must end as the unbroken one.
TEST(Lives, FivePowerCuts) { test::expect_survival(test::yielding_contact(), 5, true); }
