#include "material/laws.hpp"
#include "material/stress.hpp"

namespace {

using namespace reye;
using namespace reye::material;
using namespace reye::material::test;
using base::Analysis;

class SmallPlasticity : public testing::TestWithParam<Named> {
 protected:
  const HenckyJ2& law_ = std::get<HenckyJ2>(GetParam().material);
  double yield(double p) const { return yield_stress(law_.hardening, p); }
  /// Strain of uniaxial stress sigma at plastic strain p.
  Voigt<double> tension(double p, double sigma) const {
    const double lateral = -nu * sigma / E - p / 2;
    return {sigma / E + p, lateral, 0.0, lateral};
  }
};
INSTANTIATE_TEST_SUITE_P(all, SmallPlasticity, testing::ValuesIn(plastic_laws()), name_of);

// Uniaxial tension must follow the hardening law, in one increment or in many, as a bar and as a sheet.
TEST_P(SmallPlasticity, uniaxial_tension_is_the_hardening_curve) {
  for (auto analysis : {Analysis::axisymmetric, Analysis::plane_stress}) {
    PlasticState state;
    for (double p : {1e-6, 1e-3, 0.02, 0.0200001, 0.1, 0.5}) {
      PlasticState direct;
      const auto strain = tension(p, yield(p));
      const auto once = stress(law_, analysis, strain, {}, &direct),
                 stepped = stress(law_, analysis, strain, state, &state);
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(once[i], i == 0 ? yield(p) : 0.0, 1e-13 * E) << p;
        EXPECT_NEAR(stepped[i], once[i], 1e-13 * E) << p;
        EXPECT_NEAR(state.strain[i], i == 0 ? p : i == 2 ? 0.0 : -p / 2, 1e-14);
      }
      EXPECT_NEAR(direct.accumulated, p, 1e-14);
      EXPECT_NEAR(state.accumulated, p, 1e-14);
    }
  }
}

// In pure shear tau = sigma_y(p) / sqrt 3 at gamma = tau / mu + sqrt 3 p, in each analysis, for both signs.
TEST_P(SmallPlasticity, pure_shear) {
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress})
    for (double sign : {1.0, -1.0}) {
      const double p = 0.07, tau = yield(p) / std::sqrt(3.0);
      PlasticState state;
      const Voigt<double> strain{0.0, 0.0, sign * (tau / mu + std::sqrt(3.0) * p), 0.0};
      const auto s = stress(law_, analysis, strain, {}, &state);
      EXPECT_NEAR(s[2], sign * tau, 1e-14 * E);
      for (int i : {0, 1, 3}) EXPECT_NEAR(s[i], 0.0, 1e-14 * E);
      EXPECT_NEAR(state.accumulated, p, 1e-15);
      EXPECT_NEAR(state.strain[2], sign * std::sqrt(0.75) * p, 1e-15);
    }
}

// Unloading must be elastic and keep the plastic state to the bit.
TEST_P(SmallPlasticity, unloading_is_elastic) {
  const double p = 0.05;
  PlasticState state, after;
  stress(law_, Analysis::axisymmetric, tension(p, yield(p)), {}, &state);
  for (double sigma : {0.99 * yield(p), 0.0, -0.99 * yield(p)}) {
    EXPECT_NEAR(stress(law_, Analysis::axisymmetric, tension(p, sigma), state, &after)[0], sigma, 1e-13 * E);
    EXPECT_EQ(after.strain, state.strain);
    EXPECT_EQ(after.accumulated, state.accumulated);
  }
}

// The tangent must be that of the algorithm, plastic and elastic: the remainder falls at rate 2, or is none at all.
TEST_P(SmallPlasticity, tangent_is_consistent) {
  const Voigt<double> first{0.01, 0.0, 0.02, -0.003}, next{0.03, -0.02, 0.025, 0.004}, d{0.4, 0.7, -0.8, 0.3};
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress}) {
    PlasticState state, after;
    stress(law_, analysis, first, {}, &state);
    const auto f = [&](const auto& e) { return stress(law_, analysis, e, state, &after); };
    EXPECT_NEAR(linearisation_rate(f, next, d), 2.0, 0.02);
    EXPECT_GT(after.accumulated, state.accumulated);
    const Eigen::Matrix4d elastic = tangent(LinearElastic{E, nu}, analysis);
    const double shrink = 1e-3;  // elastic strain back from the yield surface
    const Voigt<double> back{first[0] - shrink, first[1], first[2] - shrink, first[3]};
    EXPECT_LT((tangent(law_, analysis, back, state) - elastic).norm(), 1e-11 * E);
  }
}

// Every law that is elastic at finite strain must be Hooke's law at small strain.
TEST(small_strain, elastic_laws_are_hooke) {
  const Voigt<double> strain{0.1, -0.2, 0.3, 0.05};
  for (const auto& law : hyperelastic_laws())
    for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress})
      EXPECT_EQ(stress(law.material, analysis, strain), stress(LinearElastic{E, nu}, analysis, strain)) << law.name;
}

// Hollomon hardening starts without a yield stress and with infinite slope; the increment must be found all the same.
TEST(small_plasticity, hollomon_from_the_unloaded_state) {
  const HenckyJ2 law{E, nu, SwiftHardening{700, 0.0, 0.2}};
  EXPECT_EQ(stress(law, Analysis::plane_strain, Voigt<double>{}), Voigt<double>{});
  for (double p : {1e-6, 1e-2, 1.0}) {
    const double sigma = 700 * std::pow(p, 0.2), lateral = -nu * sigma / E - p / 2;
    PlasticState after;
    const Voigt<double> strain{sigma / E + p, lateral, 0.0, lateral};
    EXPECT_NEAR(stress(law, Analysis::axisymmetric, strain, {}, &after)[0], sigma, 1e-13 * E);
    EXPECT_NEAR(after.accumulated, p, 1e-13);
  }
}

}  // namespace
