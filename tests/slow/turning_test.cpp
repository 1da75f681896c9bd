#include "solver/rolling.hpp"

using namespace reye;

// A cylinder that rolls ten revolutions must turn by the same angle in each, and press alike.
TEST(Turning, TenRevolutionsRolled) { rolling::expect_rolling(10); }

// A wheel of 20 mm that spins a thousand revolutions must neither fail nor drift.
TEST(Turning, ThousandRevolutionsSpun) { rolling::expect_no_drift(120, 24000); }
