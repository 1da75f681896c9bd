#include <random>

#include "material/finite.hpp"
#include "material/laws.hpp"

namespace {

using namespace reye;
using namespace reye::material;
using namespace reye::material::test;
using base::Analysis;

class FinitePlasticity : public testing::TestWithParam<Named> {
 protected:
  const HenckyJ2& law_ = std::get<HenckyJ2>(GetParam().material);
  double yield(double p) const { return yield_stress(law_.hardening, p); }
  /// F of uniaxial tension at plastic strain p: ln l = tau / E + p along, -nu tau / E - p / 2 across.
  Gradient<double> tension(double p, double tau) const {
    const double lateral = std::exp(-nu * tau / E - p / 2);
    return {std::exp(tau / E + p), 0, 0, lateral, lateral};
  }
};
INSTANTIATE_TEST_SUITE_P(all, FinitePlasticity, testing::ValuesIn(plastic_laws()), name_of);

// Uniaxial tension must follow the hardening law exactly, in one increment or in many, as a bar and as a sheet.
TEST_P(FinitePlasticity, uniaxial_tension_is_the_hardening_curve) {
  for (auto analysis : {Analysis::axisymmetric, Analysis::plane_stress}) {
    PlasticState stepped;
    for (double p : {1e-6, 1e-3, 0.02, 0.0200001, 0.1, 0.5, 0.9}) {
      PlasticState direct;
      for (auto& [before, after] : {std::pair<PlasticState, PlasticState&>{{}, direct}, {stepped, stepped}}) {
        const auto tau = kirchhoff(law_, analysis, tension(p, yield(p)), before, &after);
        EXPECT_NEAR(tau[0], yield(p), 1e-13 * E) << p;
        for (int i = 1; i < 4; ++i) EXPECT_NEAR(tau[i], 0.0, 1e-13 * E) << p;
        EXPECT_NEAR(after.accumulated, p, 1e-13);
        EXPECT_LT((tensor(after.strain) - tensor(Symmetric<double>{p, -p / 2, 0, -p / 2})).norm(), 1e-13) << p;
      }
    }
  }
}

// Unloading must be elastic with Young's modulus on the logarithmic strain, and keep the plastic state to the bit.
TEST_P(FinitePlasticity, unloading_is_elastic) {
  const double p = 0.3;
  PlasticState state, after;
  kirchhoff(law_, Analysis::axisymmetric, tension(p, yield(p)), {}, &state);
  for (double tau : {0.99 * yield(p), 0.0, -0.99 * yield(p)}) {
    EXPECT_NEAR(kirchhoff(law_, Analysis::axisymmetric, tension(p, tau), state, &after)[0], tau, 1e-13 * E);
    EXPECT_EQ(after.strain, state.strain);
    EXPECT_EQ(after.accumulated, state.accumulated);
  }
}

// After any path the stress must lie on the yield surface, a second look at the same F must change nothing, and the
// plastic metric must keep determinant 1.
TEST_P(FinitePlasticity, update_is_consistent_over_a_random_path) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(-0.05, 0.05);
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress}) {
    PlasticState state;
    Gradient<double> F{1, 0, 0, 1, 1};
    for (int i = 0; i < 40; ++i) {
      for (int k = 0; k < (analysis == Analysis::plane_strain ? 4 : 5); ++k) F[k] += step(random);
      const PlasticState before = state;
      const auto tau = kirchhoff(law_, analysis, F, before, &state);
      ASSERT_GE(state.accumulated, before.accumulated);
      EXPECT_LT(equivalent(tau), yield(state.accumulated) + 1e-12 * E);
      if (state.accumulated > before.accumulated) {
        EXPECT_NEAR(equivalent(tau), yield(state.accumulated), 1e-12 * E);
      }
      PlasticState again;
      EXPECT_LT((tensor(kirchhoff(law_, analysis, F, state, &again)) - tensor(tau)).norm(), 1e-12 * E);
      EXPECT_NEAR(again.accumulated, state.accumulated, 1e-13);
      EXPECT_NEAR(tensor(exponential(scaled(state.strain, 2.0))).determinant(), 1.0, 1e-13);
    }
    EXPECT_GT(state.accumulated, 0.5);
  }
}

// On a proportional path two increments must end where one does, also when a rotation comes in between.
TEST_P(FinitePlasticity, proportional_path_does_not_depend_on_its_increments) {
  const Tensor R = rotation(0.6), Q = rotation(-1.9);
  const auto stretch = [&](double s) {
    const Eigen::Vector3d l(std::exp(0.2 * s), std::exp(-0.14 * s), std::exp(-0.05 * s));
    return Tensor(R * l.asDiagonal() * R.transpose());
  };
  PlasticState one, half, two;
  const auto tau = kirchhoff(law_, Analysis::axisymmetric, gradient(stretch(1.0)), {}, &one);
  kirchhoff(law_, Analysis::axisymmetric, gradient(stretch(0.4)), {}, &half);
  const auto turned = kirchhoff(law_, Analysis::axisymmetric, gradient(Q * stretch(1.0)), half, &two);
  EXPECT_LT((Q.transpose() * tensor(turned) * Q - tensor(tau)).norm(), 1e-13 * E);
  EXPECT_LT((tensor(two.strain) - tensor(one.strain)).norm(), 1e-13);
  EXPECT_NEAR(two.accumulated, one.accumulated, 1e-13);
  EXPECT_GT(half.accumulated, 0.01);
}

// With strains scaled down, finite strain must approach small strain at first order.
TEST(finite_plasticity, small_strain_limit) {
  const Voigt<double> strain{2.0, -1.5, 1.2, 0.3};
  const auto difference = [&](Analysis analysis, double s) {
    const HenckyJ2 law{E, nu, LinearHardening{0.5 * s * E, 0.1 * E}};
    const auto& e = strain;
    const Gradient<double> F{1 + s * e[0], s * e[2] / 2, s * e[2] / 2, 1 + s * e[1], 1 + s * e[3]};
    PlasticState state;
    const auto small = stress(law, analysis, Voigt<double>{s * e[0], s * e[1], s * e[2], s * e[3]}, {}, &state);
    EXPECT_GT(state.accumulated, s);
    return (tensor(kirchhoff(law, analysis, F)) - tensor(small)).norm() / tensor(small).norm();
  };
  for (auto analysis : {Analysis::plane_strain, Analysis::plane_stress}) {
    EXPECT_LT(difference(analysis, 1e-6), 1e-5);
    EXPECT_NEAR(std::log10(difference(analysis, 1e-4) / difference(analysis, 1e-5)), 1.0, 0.02);
  }
}

}  // namespace
