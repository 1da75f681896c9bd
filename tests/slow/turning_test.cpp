#include <algorithm>

#include "solver/rolling.hpp"
#include "verification/hinge.hpp"

using namespace reye;
using namespace reye::verification;

// A cylinder that rolls ten revolutions must turn by the same angle in each, and press alike.
TEST(Turning, TenRevolutionsRolled) { rolling::expect_rolling(10); }

// A wheel of 20 mm that spins a thousand revolutions must neither fail nor drift.
TEST(Turning, ThousandRevolutionsSpun) { rolling::expect_no_drift(120, 24000); }

// A shaft that turns all round, whose fine zone is drawn for a place that it leaves at once, must wear its bush as a
// rigid one does, on facets as fine as the zone asks wherever it touches.
TEST(Turning, FullTurnsWearAsARigidShaftDoes) {
  Replacements turns{{"motion_rad = 0.5", "motion_rad = 6.283185307"},
                     {"swing = [[0, 0], [0.25, 1], [0.75, -1], [1, 0]]", "swing = [[0, 0], [1, 1]]"},
                     {"increments = 40", "increments = 24"},
                     {"cycles     = 1e4", "cycles     = 2e5"},
                     {"jump       = 5000", "jump       = { tolerance = 0.03 }"},
                     {"centre_mm = [0, -5.5], half_width_mm = 11, depth_mm = 6, size_mm = 0.4",
                      "centre_mm = [0, -10], half_width_mm = 5, depth_mm = 2, size_mm = 0.3"}};
  const auto turned = played(hinge(turns));
  turns.insert(turns.end(), verification::rigid.begin(), verification::rigid.end());
  const auto stiff = played(hinge(turns));
  EXPECT_NEAR(turned.contact().secondary.worn_area / stiff.contact().secondary.worn_area, 1.0, 0.002);
  EXPECT_NEAR(turned.contact().secondary.max_depth_mm / stiff.contact().secondary.max_depth_mm, 1.0, 0.01);
  const auto& journal = turned.problem.shapes[0]->mesh;
  double longest = 0.0;
  for (const auto& chain : journal.boundaries.at("journal"))
    for (std::size_t k = 1; k < chain.size(); ++k)
      longest = std::max(longest, (journal.X[chain[k]] - journal.X[chain[k - 1]]).norm());
  EXPECT_LT(longest, 0.31);
}
