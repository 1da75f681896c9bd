#include <gtest/gtest.h>

#include "material/energy.hpp"
#include "material/laws.hpp"

namespace {

using namespace reye::material;
using reye::base::Analysis;
using reye::material::test::analyses;

const HenckyJ2 steel{200e3, 0.3, LinearHardening{250.0, 1000.0}};

double largest_difference(const Symmetric<double>& a, const Symmetric<double>& b) {
  double most = 0.0;
  for (int i = 0; i < 4; ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

double yielding(const Symmetric<double>& e) {
  const double mean = (e[0] + e[1] + e[3]) / 3.0;
  return 3.0 * shear_modulus(steel) *
         std::sqrt(
             2.0 / 3.0 *
             (std::pow(e[0] - mean, 2) + std::pow(e[1] - mean, 2) + 2.0 * e[2] * e[2] + std::pow(e[3] - mean, 2)));
}

}  // namespace

// The stress of a state that has flowed must be Hooke's law on the elastic strain reported for it, at either
// kinematics.
TEST(ElasticPart, IsWhatTheStressFollowsFrom) {
  for (auto analysis : analyses) {
    const Voigt<double> strain{0.03, -0.02, 0.05, analysis == Analysis::plane_strain ? 0.0 : 0.001};
    const Gradient<double> F{1.3, 0.2, -0.1, 0.8, analysis == Analysis::plane_strain ? 1.0 : 1.05};
    const auto hooke = [](const ElasticState& e) {
      return combined(e.strain, 2.0 * shear_modulus(steel),
                      lame_lambda(steel) * (e.strain[0] + e.strain[1] + e.strain[3]));
    };
    PlasticState small, finite;
    const auto sigma = stress(Material(steel), analysis, strain, PlasticState{}, &small);
    const auto tau = kirchhoff(Material(steel), analysis, F, PlasticState{}, &finite);
    ASSERT_GT(small.accumulated, 0.0);
    ASSERT_GT(finite.accumulated, 0.0);
    EXPECT_LT(largest_difference(hooke(elastic_state(steel, analysis, strain, small)), sigma), 1e-9);
    EXPECT_LT(largest_difference(hooke(elastic_state(steel, analysis, F, finite)), tau), 1e-9);
  }
}

// With another deformation than the one it came from, the elastic state must still follow from the plastic state made
// for it, and p must be kept: what a transfer between meshes does.
TEST(ElasticPart, SurvivesAnotherDeformation) {
  const Symmetric<double> inside{4e-4, -3e-4, 2e-4, 1e-4};
  for (auto analysis : analyses) {
    const auto elastic = with_thickness(steel, analysis, {inside, 0.2});
    const Voigt<double> strain{0.2, -0.1, 0.3, 0.04};
    const Gradient<double> F{1.9, 0.4, -0.3, 0.6, 0.9};
    const auto small = elastic_state(steel, analysis, strain, plastic_state(analysis, strain, elastic));
    const auto finite = elastic_state(steel, analysis, F, plastic_state(analysis, F, elastic));
    EXPECT_LT(largest_difference(small.strain, elastic.strain), 1e-15);
    EXPECT_LT(largest_difference(finite.strain, elastic.strain), 1e-14);
    EXPECT_EQ(small.accumulated, 0.2);
    EXPECT_EQ(finite.accumulated, 0.2);
  }
}

// A law that does not yield must give Hooke's stress on the elastic strain of a state that has flowed, however far
// beyond its yield surface, and leave its plastic state alone, at either kinematics.
TEST(ElasticPart, MayLieBeyondTheYieldSurface) {
  const Symmetric<double> beyond{4e-3, -3e-3, 2e-3, 1e-3};
  for (auto analysis : analyses) {
    const auto elastic = with_thickness(steel, analysis, {beyond, 0.1});
    ASSERT_GT(yielding(elastic.strain), 2.0 * yield_stress(steel.hardening, 0.1));
    const auto hooke = combined(elastic.strain, 2.0 * shear_modulus(steel),
                                lame_lambda(steel) * (elastic.strain[0] + elastic.strain[1] + elastic.strain[3]));
    const Voigt<double> strain{0.03, -0.02, 0.05, 0.001};
    const Gradient<double> F{1.3, 0.2, -0.1, 0.8, 1.05};
    const auto small = plastic_state(analysis, strain, elastic), finite = plastic_state(analysis, F, elastic);
    PlasticState small_after, finite_after;
    EXPECT_LT(largest_difference(stress(unyielding(steel), analysis, strain, small, &small_after), hooke), 1e-9);
    EXPECT_LT(largest_difference(kirchhoff(unyielding(steel), analysis, F, finite, &finite_after), hooke), 1e-9);
    EXPECT_EQ(small_after.strain, small.strain);
    EXPECT_EQ(finite_after.strain, finite.strain);
  }
}
