#include <gtest/gtest.h>

#include "base/dual.hpp"
#include "wear/law.hpp"

namespace {

using namespace reye;
using wear::Law;
using wear::LawKind;
using Two = base::Dual<2>;

// The energy law must count |shear x slip|, Archard's |pressure x slip|, none nothing; signs do not matter.
TEST(law, work) {
  const Law energy{LawKind::energy, 1e-7, 0.0}, archard{LawKind::archard, 1e-8, 0.0}, none;
  for (double sign : {-1.0, 1.0}) {
    EXPECT_EQ(wear::work(energy, 10.0, sign * 3.0, 0.5), 1.5);
    EXPECT_EQ(wear::work(energy, 10.0, 3.0, sign * 0.5), 1.5);
    EXPECT_EQ(wear::work(archard, 10.0, sign * 3.0, -0.5), 5.0);
    EXPECT_EQ(wear::work(none, 10.0, 3.0, 0.5), 0.0);
  }
}

// In full slip Archard with k must remove what the energy law with alpha = k / mu removes.
TEST(law, archard_and_energy_agree_in_full_slip) {
  const double mu = 0.3, k = 2e-8, p = 120.0, slip = 0.7;
  const Law energy{LawKind::energy, k / mu, 0.0}, archard{LawKind::archard, k, 0.0};
  EXPECT_NEAR(energy.secondary * wear::work(energy, p, mu * p, slip), archard.secondary * wear::work(archard, p, mu * p, slip),
              1e-22);
}

// The derivative of the work must carry the sign of the product.
TEST(law, derivative) {
  const Law energy{LawKind::energy, 1.0, 0.0};
  const Two w = wear::work(energy, Two(10.0), Two::variable(-3.0, 0), Two::variable(0.5, 1));
  EXPECT_EQ(w.v, 1.5);
  EXPECT_EQ(w.d[0], -0.5);
  EXPECT_EQ(w.d[1], 3.0);
}

// A law must wear only with a kind and a coefficient on some side.
TEST(law, wears) {
  EXPECT_FALSE(Law{}.wears());
  EXPECT_FALSE((Law{LawKind::energy, 0.0, 0.0}).wears());
  EXPECT_TRUE((Law{LawKind::energy, 0.0, 1e-7}).wears());
  EXPECT_TRUE((Law{LawKind::archard, 1e-7, 0.0}).wears());
}

// The ledger must compare both sides' removed volume with the sum of the coefficients times the work.
TEST(ledger, relative_error) {
  const Law law{LawKind::energy, 1e-3, 3e-3};
  EXPECT_EQ(wear::Ledger{}.relative_error(law), 0.0);
  EXPECT_NEAR((wear::Ledger{100.0, 0.1, 0.3}).relative_error(law), 0.0, 1e-15);
  EXPECT_NEAR((wear::Ledger{100.0, 0.1, 0.34}).relative_error(law), 0.1, 1e-14);
  EXPECT_NEAR((wear::Ledger{100.0, 0.4, 0.4}).relative_error(law), 1.0, 1e-14);
}

}  // namespace
