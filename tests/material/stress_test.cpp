#include "material/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace reye;
using base::Analysis;
using material::LinearElastic;
using material::Voigt;

constexpr double E = 200e3, nu = 0.3;
const LinearElastic linear_steel{E, nu};

// The derivative by dual numbers must be the elastic matrix of the textbooks.
TEST(stress, dual_derivative_is_the_elastic_matrix) {
  const double f = E / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));
  Eigen::Matrix4d solid;
  solid << f * (1 - nu), f * nu, 0, f * nu,  //
      f * nu, f * (1 - nu), 0, f * nu,       //
      0, 0, G, 0,                            //
      f * nu, f * nu, 0, f * (1 - nu);
  const double g = E / (1 - nu * nu);
  Eigen::Matrix4d thin;
  thin << g, g * nu, 0, 0, g * nu, g, 0, 0, 0, 0, G, 0, 0, 0, 0, 0;
  const Voigt<double> anywhere{1e-3, -2e-3, 5e-4, 3e-4};
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric})
    EXPECT_LT((material::tangent(linear_steel, analysis, anywhere) - solid).norm(), 1e-14 * solid.norm());
  EXPECT_LT((material::tangent(linear_steel, Analysis::plane_stress, anywhere) - thin).norm(), 1e-14 * thin.norm());
}

// Values and duals must come from one formula: the stress is the tangent times the strain.
TEST(stress, is_linear_in_strain) {
  const Voigt<double> e{1e-3, -2e-3, 5e-4, 3e-4};
  for (auto analysis : {Analysis::plane_strain, Analysis::plane_stress, Analysis::axisymmetric}) {
    const auto s = material::stress(material::Material(linear_steel), analysis, e);
    const Eigen::Vector4d expected =
        material::tangent(linear_steel, analysis) * Eigen::Vector4d(e[0], e[1], e[2], e[3]);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(s[i], expected[i], 1e-12 * expected.norm());
  }
}

// In plane stress uniaxial tension must give E eps with the contraction nu, and no stress in thickness.
TEST(stress, plane_stress_is_uniaxial) {
  const auto s = material::stress(linear_steel, Analysis::plane_stress, Voigt<double>{1e-3, -nu * 1e-3, 0.0, 99.0});
  EXPECT_NEAR(s[0], E * 1e-3, 1e-10);
  EXPECT_NEAR(s[1], 0.0, 1e-10);
  EXPECT_EQ(s[3], 0.0);
}

}  // namespace
