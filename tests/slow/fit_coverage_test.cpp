#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/scars.hpp"

namespace {

using namespace reye;
using base::Vec2;
using base::Vector;
using support::Scar;

constexpr int fits = 400;

const char* name_of(Scar scar) { return scar == Scar::parabola ? "parabola" : scar == Scar::u ? "U" : "W"; }

/// How often intervals held the truth, which is 0 for every parameter.
struct Tally {
  explicit Tally(Eigen::Index p) : held(Vector::Zero(p)), deviation(Vector::Zero(p)), error(Vector::Zero(p)) {}
  Vector held, deviation, error;
  int poor = 0, refused = 0;

  void add(const fit::Estimate& result) {
    poor += !result.poor.empty();
    refused += !result.refused.empty();
    if (!result.refused.empty()) return;  // its interval would reach over a factor of a thousand: it misses nothing
    for (Eigen::Index k = 0; k < held.size(); ++k) held[k] += result.low[k] <= 0.0 && result.high[k] >= 0.0;
    deviation += result.covariance.diagonal().cwiseSqrt();
    error += result.theta.cwiseAbs2();
  }
  /// Prints a row of the table for each parameter, and holds it to what is promised.
  void check(const std::string& what, double least, double most) const {
    const double answered = fits - refused;
    for (Eigen::Index k = 0; k < held.size(); ++k) {
      const double percent = 100.0 * (held[k] + refused) / fits;
      std::printf("coverage,%s,%d,%.1f,%.4f,%.4f,%.1f,%.1f\n", what.c_str(), static_cast<int>(k + 1), percent,
                  deviation[k] / answered, std::sqrt(error[k] / answered), 100.0 * poor / fits, 100.0 * refused / fits);
      std::fflush(stdout);
      EXPECT_GE(percent, least) << what;
      EXPECT_LE(percent, most) << what;
    }
    EXPECT_LE(poor, 3 * fits / 200) << what;  // edges make tails heavier than those of the test at 0.001
  }
};

std::string row(const char* kind, Scar scar, double noise, double correlation) {
  char text[100];
  std::snprintf(text, sizeof text, "%s,%s,%.2f,%.2f", kind, name_of(scar), noise, correlation);
  return text;
}

void one_profile(const char* kind, double from, double to, double least = 92.0, double most = 98.0) {
  for (const Scar scar : {Scar::parabola, Scar::u, Scar::w})
    for (const double noise : {0.01, 0.05, 0.2})
      for (const double correlation : {0.0, 0.02, 0.05, 0.1}) {
        std::mt19937_64 random(11);
        Tally tally(1);
        for (int i = 0; i < fits; ++i) {
          const auto series = support::profile(
              random, {.scar = scar, .noise = noise, .correlation = correlation, .from = from, .to = to});
          tally.add(fit::estimate({series}, support::model_of(scar, {series}, {1.0}), {"k"}, Vector::Constant(1, 0.5)));
        }
        tally.check(row(kind, scar, noise, correlation), least, most);
      }
}

/// Two profiles at tau of 1 and `second`; `both`: one coefficient, else two: of the first, and the ratio.
void two_profiles(const char* kind, double second, bool both) {
  for (const Scar scar : {Scar::parabola, Scar::u})
    for (const double noise : {0.01, 0.05, 0.2})
      for (const double correlation : {0.0, 0.02, 0.1}) {
        std::mt19937_64 random(12);
        Tally tally(both ? 1 : 2);
        for (int i = 0; i < fits; ++i) {
          const support::Measured measured{.scar = scar, .noise = noise, .correlation = correlation};
          std::vector<fit::Series> series{support::profile(random, measured)};
          support::Measured other = measured;
          other.tau = second;
          series.push_back(support::profile(random, other));
          series[1].name = "scar[1]";
          const auto model = support::model_of(scar, series, {1.0, second});
          const fit::Model of_sides = [&](const Vector& theta, std::size_t s, const Vec2& shift) {
            return model(Vector::Constant(1, s == 0 ? theta[0] : theta.sum()), s, shift);
          };
          tally.add(both ? fit::estimate(series, model, {"k"}, Vector::Constant(1, 0.3))
                         : fit::estimate(series, of_sides, {"k", "ratio"}, Vector::Constant(2, 0.3)));
        }
        tally.check(row(kind, scar, noise, correlation), 92.0, 98.0);
      }
}

// The 95 % interval of a whole profile must hold the true coefficient, whatever shape, noise and correlation.
TEST(FitCoverage, OneProfile) { one_profile("one profile", -1.0, 1.0); }

// It must nearly hold where both ends are cut at the scar, so that next to nothing of the unworn surface is seen. Of
// noise that is correlated over a tenth of the width some ten lengths are left then, from which
// its reach cannot be known.
TEST(FitCoverage, CutEnds) { one_profile("cut ends", -0.55, 0.55, 91.0, 99.0); }

// It must nearly hold where most of one flank is missing, too.
TEST(FitCoverage, FlankMissing) { one_profile("a flank missing", -0.35, 1.0, 91.0, 99.0); }

// It must hold for two profiles at two cycles.
TEST(FitCoverage, TwoProfiles) { two_profiles("two profiles", 3.0, true); }

// It must hold for each of two parameters, the wear of one side and the ratio to the other.
TEST(FitCoverage, TwoSides) { two_profiles("two sides", 0.5, false); }

}  // namespace
