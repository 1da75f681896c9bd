#include "solver/rolling.hpp"

using namespace reye;

// A wheel that a plate rolls must turn by the plate's way over its rim, without swelling, creeping away or pulling.
TEST(rolling, wheel_turns_by_the_way) { rolling::expect_rolling(2); }

// A wheel that spins must press and rub after every step of a turn as after the first.
TEST(rolling, spinning_wheel_does_not_drift) { rolling::expect_no_drift(120, 48); }
