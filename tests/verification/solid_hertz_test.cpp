#include <gtest/gtest.h>

#include "support/solid_hertz.hpp"

using namespace reye;

namespace {

struct HertzError {
  double p0, a, newton;
};

HertzError hertz_error(mesh::SolidKind kind, double elements) {
  support::HertzCase c;
  c.kind = kind;
  c.elements = elements;
  const auto played = support::play(support::hertz_problem(c));
  EXPECT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  if (played.frames.empty()) return {1.0, 1.0, 0.0};
  const auto fit = support::fit_hertz(played.frames.back().surfaces.front(), c.a_mm);
  EXPECT_LE(played.summary.balance, 1e-10);
  return {std::abs(fit.p0 / c.p0() - 1.0), std::abs(fit.a / c.a_mm - 1.0),
          static_cast<double>(played.summary.counts.newton_iterations)};
}

}  // namespace

TEST(SolidHertz, PeakPressureAndRadiusOfABallOnAFlat) {
  // A ball on a flat: largest pressure and radius of contact are Hertz's, with six hexahedra per radius within 0.5 %,
  // with three tetrahedra of second order within 5 %; Newton's iteration needs at most 12 steps from no contact at all.
  const auto hexahedra = hertz_error(mesh::SolidKind::hex8, 6.0);
  EXPECT_LE(hexahedra.p0, 0.005);
  EXPECT_LE(hexahedra.a, 0.02);
  EXPECT_LE(hexahedra.newton, 12.0);
  const auto tetrahedra = hertz_error(mesh::SolidKind::tet10, 3.0);
  EXPECT_LE(tetrahedra.p0, 0.05);
  EXPECT_LE(tetrahedra.a, 0.05);
}
