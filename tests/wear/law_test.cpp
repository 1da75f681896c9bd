#include <gtest/gtest.h>

#include "base/dual.hpp"
#include "wear/law.hpp"

namespace {

using namespace reye;
using wear::along_a_line;
using wear::Law;
using wear::LawKind;
using wear::Start;
using Two = base::Dual<2>;
using Four = base::Dual<4>;

template <class T>
T plain(const Law& law, const T& pressure, const T& shear, const T& slip) {
  return wear::plain_work(law, along_a_line(pressure, shear, slip, T(1.0)));
}

// The energy law must count |shear x slip|, Archard's |pressure x slip|, none nothing; signs do not matter.
TEST(law, work) {
  const Law energy{LawKind::energy, 1e-7, 0.0}, archard{LawKind::archard, 1e-8, 0.0}, none;
  for (double sign : {-1.0, 1.0}) {
    EXPECT_EQ(plain(energy, 10.0, sign * 3.0, 0.5), 1.5);
    EXPECT_EQ(plain(energy, 10.0, 3.0, sign * 0.5), 1.5);
    EXPECT_EQ(plain(archard, 10.0, sign * 3.0, -0.5), 5.0);
    EXPECT_EQ(plain(none, 10.0, 3.0, 0.5), 0.0);
  }
}

// In full slip Archard with k must remove what the energy law with alpha = k / mu removes.
TEST(law, archard_and_energy_agree_in_full_slip) {
  const double mu = 0.3, k = 2e-8, p = 120.0, slip = 0.7;
  const Law energy{LawKind::energy, k / mu, 0.0}, archard{LawKind::archard, k, 0.0};
  EXPECT_NEAR(energy.secondary * plain(energy, p, mu * p, slip), archard.secondary * plain(archard, p, mu * p, slip),
              1e-22);
}

// The derivative of the work must carry the sign of the product.
TEST(law, derivative) {
  const Law energy{LawKind::energy, 1.0, 0.0};
  const Two w = plain(energy, Two(10.0), Two::variable(-3.0, 0), Two::variable(0.5, 1));
  EXPECT_EQ(w.v, 1.5);
  EXPECT_EQ(w.d[0], -0.5);
  EXPECT_EQ(w.d[1], 3.0);
}

// Without exponents and threshold the whole law must be the plain one, bit by bit, whatever the increment is.
TEST(law, plain_without_exponents_and_threshold) {
  for (const auto kind : {LawKind::energy, LawKind::archard, LawKind::none}) {
    const Law law{.kind = kind, .secondary = 1e-7, .pressure_ref = 3.0, .speed_ref = 7.0};
    for (int i = 1; i < 50; ++i) {
      const double n = 10.0 / i, t = 0.3 * n * std::cos(i), u = 0.01 * std::sin(i), D = 0.1 + 0.01 * i;
      EXPECT_EQ(wear::work(law, along_a_line(n, t, u, D), {3.0, 0.7, 0.1 * i, 0.2}), plain(law, n, t, u));
    }
  }
}

// The work must be multiplied by (p / p_ref)^m (v / v_ref)^n, v the slip over the duration of one play.
TEST(law, factors_of_pressure_and_speed) {
  Law law{.kind = LawKind::energy, .secondary = 1.0, .pressure_exponent = 0.5, .pressure_ref = 40.0};
  const Start start{.jump = 100.0, .duration_s = 0.25};
  const auto s = along_a_line(10.0, -3.0, -0.6, 0.2);  // 3 mm in 0.25 s: 12 mm/s
  EXPECT_NEAR(wear::work(law, s, start), 1.8 * 0.5, 1e-15);
  law.speed_exponent = -2.0 / 3.0;
  law.speed_ref = 1.5;
  EXPECT_NEAR(wear::work(law, s, start), 1.8 * 0.5 * 0.25, 1e-15);
  law.kind = LawKind::archard;
  EXPECT_NEAR(wear::work(law, s, start), 6.0 * 0.5 * 0.25, 1e-15);
}

// Nothing must wear below the threshold, the part beyond it in the increment that crosses, all from then on.
TEST(law, threshold) {
  const Law law{.kind = LawKind::energy, .secondary = 1.0, .threshold = 20.0};
  const auto s = along_a_line(10.0, 3.0, 0.5, 0.2);  // work 1.5
  const auto work = [&](double energy) {
    return wear::work(law, s, {.jump = 4.0, .duration_s = 0.0, .energy = energy, .area = 0.5});
  };
  EXPECT_EQ(work(0.0), 0.0);
  EXPECT_EQ(work(10.0 - 4.0 * 1.5), 0.0);
  EXPECT_NEAR(work(10.0 - 4.0 * 0.5), 1.0, 1e-15);
  EXPECT_EQ(work(10.0), 1.5);
  EXPECT_EQ(work(11.0), 1.5);
}

/// The work and its derivatives by pressure, shear, slip and covered length.
Four differentiated(const Law& law, const std::array<double, 4>& x, const Start& start) {
  return wear::work(
      law,
      along_a_line(Four::variable(x[0], 0), Four::variable(x[1], 1), Four::variable(x[2], 2), Four::variable(x[3], 3)),
      start);
}

// The derivative of the whole law must be met by central differences at second order, above and across the threshold.
TEST(law, derivative_with_factors_and_threshold) {
  const Law law{LawKind::energy, 1.0, 0.0, 0.7, 40.0, -0.3, 1.5, 20.0};
  const std::array<double, 4> x{10.0, -3.0, -0.6, 0.2}, way{1.0, -0.4, 0.05, 0.02};
  for (const double energy : {7.0, 12.0}) {
    const Start start{3.0, 0.25, energy, 0.5};
    const auto at = [&](double h) {
      return wear::work(law, along_a_line(x[0] + h * way[0], x[1] + h * way[1], x[2] + h * way[2], x[3] + h * way[3]),
                        start);
    };
    const auto w = differentiated(law, x, start);
    EXPECT_EQ(w.v, at(0.0));
    double slope = 0.0;
    for (int i = 0; i < 4; ++i) slope += w.d[i] * way[i];
    const auto error = [&](double h) { return std::abs((at(h) - at(-h)) / (2.0 * h) - slope); };
    EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 2.0, 0.01) << energy;
  }
}

// Where pressure or slip vanishes, work must vanish with it and keep a finite slope, whatever the signs of the
// exponents.
TEST(law, vanishes_with_the_traction) {
  for (const double m : {-0.9, -0.5, 0.5, 2.0})
    for (const double n : {-0.9, 0.5}) {
      const Law law{LawKind::archard, 1.0, 0.0, m, 10.0, n, 1.0};
      const Start start{1.0, 1.0, 0.0, 1.0};
      EXPECT_EQ(differentiated(law, {0.0, 0.0, 0.1, 0.2}, start).v, 0.0);
      EXPECT_EQ(differentiated(law, {5.0, 0.0, 0.0, 0.2}, start).v, 0.0);
      for (const double p : {-1.0, 0.0, 1e-7})
        for (const double d : differentiated(law, {p, 0.0, 0.0, 0.2}, start).d)
          EXPECT_TRUE(std::isfinite(d)) << m << ' ' << n;
    }
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
  EXPECT_EQ(wear::Ledger{}.relative_error(), 0.0);
  EXPECT_NEAR((wear::Ledger{0.4, 0.1, 0.3}).relative_error(), 0.0, 1e-15);
  EXPECT_NEAR((wear::Ledger{0.4, 0.1, 0.34}).relative_error(), 0.1, 1e-14);
  EXPECT_NEAR((wear::Ledger{0.4, 0.4, 0.4}).relative_error(), 1.0, 1e-14);
}

}  // namespace
