#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "base/analysis.hpp"
#include "base/dual.hpp"

using reye::base::Dual;
using reye::base::out_of_plane;
using reye::base::value;

namespace {

using Two = Dual<2>;

/// A function of two variables, for doubles and for duals.
struct Operation {
  const char* name;
  std::function<double(double, double)> plain;
  std::function<Two(const Two&, const Two&)> dual;
};

template <class F>
Operation operation(const char* name, F f) {
  return {name, [f](double a, double b) { return f(a, b); }, [f](const Two& a, const Two& b) { return Two(f(a, b)); }};
}

/// Every operator, with constants on either side, and every function.
std::vector<Operation> operations() {
  using std::abs, std::cos, std::exp, std::log, std::sin, std::sqrt;
  return {
      operation("a + b", [](auto a, auto b) { return a + b; }),
      operation("a - b", [](auto a, auto b) { return a - b; }),
      operation("a * b", [](auto a, auto b) { return a * b; }),
      operation("a / b", [](auto a, auto b) { return a / b; }),
      operation("-a", [](auto a, auto b) { return -a * b; }),
      operation("a + 2", [](auto a, auto b) { return (a + 2.0) * b; }),
      operation("2 + a", [](auto a, auto b) { return (2.0 + a) * b; }),
      operation("a - 2", [](auto a, auto b) { return (a - 2.0) * b; }),
      operation("2 - a", [](auto a, auto b) { return (2.0 - a) * b; }),
      operation("3 a", [](auto a, auto b) { return 3.0 * a * b; }),
      operation("a 3", [](auto a, auto b) { return a * 3.0 * b; }),
      operation("a / 3", [](auto a, auto b) { return a / 3.0 * b; }),
      operation("3 / a", [](auto a, auto b) { return decltype(a)(3.0) / a * b; }),
      operation("sqrt", [](auto a, auto b) { return sqrt(a * b); }),
      operation("abs", [](auto a, auto b) { return abs(b - 10.0 * a) * a; }),
      operation("log", [](auto a, auto b) { return log(a) * b; }),
      operation("exp", [](auto a, auto b) { return exp(a * b); }),
      operation("sin", [](auto a, auto b) { return sin(a) * b; }),
      operation("cos", [](auto a, auto b) { return cos(a) * b; }),
      operation("+=",
                [](auto a, auto b) {
                  auto c = a * a;
                  c += b * b * b;
                  return c;
                }),
      operation("-=",
                [](auto a, auto b) {
                  auto c = a * a;
                  c -= b * b * b;
                  return c;
                }),
      operation("*=",
                [](auto a, auto b) {
                  auto c = a * a;
                  c *= b;
                  return c;
                }),
      operation("/=",
                [](auto a, auto b) {
                  auto c = a * a;
                  c /= b;
                  return c;
                }),
      operation("a a",
                [](auto a, auto b) {
                  auto c = a;
                  c *= c;
                  return c * b;
                }),
  };
}

/// Error of the directional derivative from a central difference of width h.
double difference_error(const Operation& f, double a, double b, const std::array<double, 2>& d, double h) {
  const Two y = f.dual(Two::variable(a, 0), Two::variable(b, 1));
  const double slope = (f.plain(a + h * d[0], b + h * d[1]) - f.plain(a - h * d[0], b - h * d[1])) / (2.0 * h);
  return std::abs(slope - (y.d[0] * d[0] + y.d[1] * d[1]));
}

}  // namespace

// Every operation must give the plain value, and a derivative that central differences approach at rate 2.
TEST(Dual, EveryOperationAgainstDifferences) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(0.5, 2.0);
  for (const auto& f : operations())
    for (int trial = 0; trial < 5; ++trial) {
      const double a = between(random), b = between(random);
      EXPECT_DOUBLE_EQ(value(f.dual(a, b)), f.plain(a, b)) << f.name;
      const std::array d{between(random), -between(random)};
      const double coarse = difference_error(f, a, b, d, 2e-3), fine = difference_error(f, a, b, d, 1e-3);
      EXPECT_LT(fine, 1e-3) << f.name;
      if (coarse > 1e-9) {
        EXPECT_GT(std::log2(coarse / fine), 1.9) << f.name;
      }
    }
}

// Decisions must see the value alone, and a constant must carry no derivative.
TEST(Dual, DecisionsAndConstants) {
  const Two a = Two::variable(1.0, 0), b = Two::variable(2.0, 1);
  EXPECT_TRUE(a < b);
  EXPECT_TRUE(b > a);
  EXPECT_FALSE(a < a);
  EXPECT_EQ(value(a), 1.0);
  EXPECT_EQ(value(3.0), 3.0);
  EXPECT_EQ(Two(4.0).d, (std::array{0.0, 0.0}));
  EXPECT_EQ(a.d, (std::array{1.0, 0.0}));
}

// In axisymmetry an integral must count the whole circumference, with its derivative; in the plane one mm.
TEST(Dual, WeightOfTheOutOfPlaneDirection) {
  using reye::base::Analysis;
  const Two r = Two::variable(3.0, 0);
  const Two ring = out_of_plane(Analysis::axisymmetric, r);
  EXPECT_DOUBLE_EQ(ring.v, 6.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(ring.d[0], 2.0 * std::numbers::pi);
  for (const auto plane : {Analysis::plane_strain, Analysis::plane_stress}) {
    EXPECT_EQ(out_of_plane(plane, r).v, 1.0);
    EXPECT_EQ(out_of_plane(plane, r).d[0], 0.0);
  }
}
