#include "material/local_newton.hpp"

#include <gtest/gtest.h>

namespace {

using namespace reye;
using base::Dual;
using material::root;
using material::solved;

// A root must be found where plain Newton fails: infinite slope at the start, overshoot, a corner between two slopes.
TEST(local_newton, finds_the_root_where_newton_alone_fails) {
  const auto steep = root([](const Dual<1>& x) { return sqrt(x) - 0.3; }, {0.0, 0.0, 1.0});
  EXPECT_NEAR(steep.value().x, 0.09, 1e-13);
  const auto flat = root([](const Dual<1>& x) { return exp(20.0 * x) - 1.0; }, {-0.9, -1.0, 5.0});
  EXPECT_NEAR(flat.value().x, 0.0, 1e-13);
  const auto corner = root([](const Dual<1>& x) { return x < 1.0 ? 0.01 * (x - 1.0) - 1e-3 : 50.0 * (x - 1.0) - 1e-3; },
                           {0.2, 0.0, 10.0});
  EXPECT_NEAR(corner.value().x, 1.0 + 2e-5, 1e-13);
}

// The derivative of x(a) must be that of the implicit function: x^3 = a gives dx/da = 1 / (3 x^2).
TEST(local_newton, carries_the_derivative_of_the_implicit_function) {
  const auto cube = [](const auto& a, const auto& x) { return x * x * x - a[0]; };
  const auto x = solved(cube, std::array{Dual<1>::variable(8.0, 0)}, {1.0, 0.0, 10.0}, "cube root of");
  EXPECT_NEAR(x.v, 2.0, 1e-15);
  EXPECT_NEAR(x.d[0], 1.0 / 12.0, 1e-13);
}

// Where there is no root, or no number, the failure must be an error that names the unknown and its arguments.
TEST(local_newton, says_what_it_did_not_find) {
  const auto positive = [](const auto& a, const auto& x) { return x * x + a[0]; };
  const auto message = [&](double a) -> std::string {
    try {
      solved(positive, std::array{a}, {1.0, 0.0, 10.0}, "square root of");
    } catch (const base::SolveError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(2.0), "no square root of 2.000000");
  EXPECT_EQ(message(std::nan("")), "no square root of nan");
}

}  // namespace
