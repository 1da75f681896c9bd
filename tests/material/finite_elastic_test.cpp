#include "material/finite.hpp"
#include "material/laws.hpp"

namespace {

using namespace reye;
using namespace reye::material;
using namespace reye::material::test;
using base::Analysis;

void expect_stress(const Voigt<double>& tau, const Voigt<double>& expected) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(tau[i], expected[i], 1e-14 * E) << "component " << i;
}

class FiniteLaw : public testing::TestWithParam<Named> {
 protected:
  const Material& material_ = GetParam().material;
};
INSTANTIATE_TEST_SUITE_P(all, FiniteLaw, testing::ValuesIn(finite_laws()), name_of);

// Without strain every law must be Hooke's law: no stress, and dP/dF its elastic matrix, in each analysis.
TEST_P(FiniteLaw, small_strain_limit_is_hooke) {
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress}) {
    Gradient<base::Dual<5>> F{1.0, 0.0, 0.0, 1.0, 1.0};
    for (int i = 0; i < 5; ++i) F[i].d[i] = 1.0;
    const auto P = first_piola(material_, analysis, F);
    const Eigen::Matrix4d C = tangent(LinearElastic{E, nu}, analysis);
    const int voigt[] = {0, 2, 2, 1, 3};
    for (int i = 0; i < 5; ++i) {
      EXPECT_NEAR(P[i].v, 0.0, 1e-14 * E);
      for (int j = 0; j < 5; ++j) EXPECT_NEAR(P[i].d[j], C(voigt[i], voigt[j]), 1e-12 * E) << i << j;
    }
  }
}

// However small a strain is, its stress must be Hooke's to the digits of the strain: not those of F = I + H.
TEST_P(FiniteLaw, small_strain_keeps_its_digits) {
  const double e = 1e-13;
  const Gradient<double> H{2.0 * e, 1.7 * e, -0.5 * e, -1.5 * e, 0.3 * e};
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress}) {
    const Voigt<double> hooke = stress(LinearElastic{E, nu}, analysis, Voigt<double>{H[0], H[3], H[1] + H[2], H[4]});
    const auto P = first_piola_from(material_, analysis, H);
    const int voigt[] = {0, 2, 2, 1, 3};
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(P[i], hooke[voigt[i]], 1e-11 * e * E) << i;
  }
}

// In plane stress tau_33 must vanish, and the stress be that of plane strain at the condensed stretch.
TEST_P(FiniteLaw, plane_stress_has_no_stress_in_thickness) {
  const auto [state, first, F] = loaded(material_, Analysis::plane_stress);
  auto whole = F;
  whole[4] = thickness_stretch(material_, Analysis::plane_stress, F, state);
  const auto tau = kirchhoff(material_, Analysis::plane_stress, F, state);
  EXPECT_NEAR(tau[3], 0.0, 1e-14 * E);
  expect_stress(tau, kirchhoff(material_, Analysis::plane_strain, whole, state));
}

// P must be tau F^-T: it transports the same force.
TEST_P(FiniteLaw, first_piola_is_tau_F_minus_T) {
  const auto [state, first, F] = loaded(material_, Analysis::plane_strain);
  const Tensor expected =
      tensor(kirchhoff(material_, Analysis::plane_strain, F, state)) * tensor(F).inverse().transpose();
  const Tensor P = tensor(first_piola(material_, Analysis::plane_strain, F, state));
  EXPECT_LT((P - expected).norm(), 1e-14 * E);
}

// A deformation without positive volume must be an error with its determinant, never a stress.
TEST_P(FiniteLaw, inverted_element_is_an_error) {
  for (const Gradient<double>& F : {Gradient<double>{1, 0, 0, -0.5, 1},
                                    {1, 0, 0, 0, 1},
                                    {-1, 0, 0, 1, -1},
                                    {1, std::nan(""), 0, 1, 1},
                                    {1e200, 0, 0, 1e200, 1}})
    EXPECT_THROW(kirchhoff(material_, Analysis::plane_strain, F), base::SolveError);
  try {
    kirchhoff(material_, Analysis::plane_strain, Gradient<double>{1, 0, 0, -0.5, 1});
  } catch (const base::SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("determinant -0.5"), std::string::npos) << error.what();
  }
}

class NeoHookeanLaw : public testing::TestWithParam<Named> {};
INSTANTIATE_TEST_SUITE_P(all, NeoHookeanLaw, testing::ValuesIn(neo_hookean_laws()), name_of);

// In simple shear every neo-Hookean form must give tau_12 = mu gamma and tau_11 = mu gamma^2, since J = 1.
TEST_P(NeoHookeanLaw, simple_shear) {
  const double g = 0.7;
  expect_stress(kirchhoff(GetParam().material, Analysis::plane_strain, Gradient<double>{1, g, 0, 1, 1}),
                {mu * g * g, 0, mu * g, 0});
}

// In uniaxial tension the lateral stretch b of a neo-Hookean form follows from J: mu (1 - b^2) = J U'(J).
TEST_P(NeoHookeanLaw, uniaxial_tension) {
  for (double J : {0.9, 1.1}) {
    const double beta = nu / (1 - 2 * nu);
    const double JU[] = {lambda * std::log(J), lambda * J * (J - 1), lambda / 2 * (J * J - 1),
                         mu * (1 - std::pow(J, -2 * beta))};
    const auto& law = std::get<NeoHookean>(GetParam().material);
    const double lateral = std::sqrt(1 - JU[static_cast<int>(law.volumetric)] / mu), l = J / (lateral * lateral);
    const Voigt<double> expected{mu * (l * l - lateral * lateral), 0, 0, 0};
    const Gradient<double> F{l, 0, 0, lateral, lateral};
    expect_stress(kirchhoff(law, Analysis::axisymmetric, F), expected);
    expect_stress(kirchhoff(law, Analysis::plane_stress, Gradient<double>{l, 0, 0, lateral, 9.0}), expected);
    EXPECT_NEAR(thickness_stretch(law, Analysis::plane_stress, F), lateral, 1e-14);
  }
}

// The power form must contract as stretch^-nu, whatever the stretch.
TEST(finite_elastic, power_form_keeps_poissons_ratio) {
  const NeoHookean law{E, nu, Volumetric::power};
  for (double l : {0.5, 2.0}) {
    const double lateral = std::pow(l, -nu);
    EXPECT_NEAR(thickness_stretch(law, Analysis::plane_stress, Gradient<double>{l, 0, 0, lateral, 1}), lateral, 1e-14);
  }
}

// St Venant-Kirchhoff in simple shear and in uniaxial tension, where E_lateral = -nu E_axial.
TEST(finite_elastic, st_venant_kirchhoff_closed_forms) {
  const StVenantKirchhoff law{E, nu};
  const double g = 0.4, S11 = lambda * g * g / 2, S12 = mu * g, S22 = S11 + mu * g * g;
  expect_stress(kirchhoff(law, Analysis::plane_strain, Gradient<double>{1, g, 0, 1, 1}),
                {S11 + 2 * g * S12 + g * g * S22, S22, S12 + g * S22, S11});
  const double l = 1.3, strain = (l * l - 1) / 2, lateral = std::sqrt(1 - 2 * nu * strain);
  expect_stress(kirchhoff(law, Analysis::plane_stress, Gradient<double>{l, 0, 0, lateral, 1}),
                {l * l * E * strain, 0, 0, 0});
}

// Hencky in simple shear, principal logarithmic strain asinh(gamma / 2), and in uniaxial tension tau = E ln l; or
// sigma.
TEST(finite_elastic, hencky_closed_forms) {
  const Hencky law{E, nu};
  const double g = 1.4, log_stretch = std::asinh(g / 2), c = std::sqrt(1 + g * g / 4);
  const double shear = 2 * mu * log_stretch / c;
  expect_stress(kirchhoff(law, Analysis::plane_strain, Gradient<double>{1, g, 0, 1, 1}),
                {shear * g / 2, -shear * g / 2, shear, 0});
  const double l = 1.8, lateral = std::pow(l, -nu);
  expect_stress(kirchhoff(law, Analysis::plane_stress, Gradient<double>{l, 0, 0, lateral, 1}),
                {E * std::log(l), 0, 0, 0});
  expect_stress(kirchhoff(Hencky{E, nu, true}, Analysis::plane_stress, Gradient<double>{l, 0, 0, lateral, 1}),
                {l * lateral * lateral * E * std::log(l), 0, 0, 0});
}

// A St Venant-Kirchhoff sheet has no thickness at which tau_33 = 0 once tr C > 3 + 2 mu / lambda: an error.
TEST(finite_elastic, st_venant_kirchhoff_sheet_stretched_too_far) {
  const double limit = std::sqrt((3 + 2 * mu / lambda) / 2);
  const StVenantKirchhoff law{E, nu};
  const Gradient<double> below{0.999 * limit, 0, 0, 0.999 * limit, 1}, above{1.001 * limit, 0, 0, 1.001 * limit, 1};
  EXPECT_NEAR(kirchhoff(law, Analysis::plane_stress, below)[3], 0.0, 1e-14 * E);
  EXPECT_THROW(kirchhoff(law, Analysis::plane_stress, above), base::SolveError);
}

// Linear elasticity must be refused at finite strain, and only there.
TEST(finite_elastic, linear_elasticity_is_a_law_of_small_strain) {
  const Material linear = LinearElastic{E, nu};
  EXPECT_TRUE(supports(linear, base::Kinematics::small));
  EXPECT_FALSE(supports(linear, base::Kinematics::finite));
  EXPECT_THROW(kirchhoff(linear, Analysis::plane_strain, Gradient<double>{1, 0, 0, 1, 1}), std::logic_error);
  for (const auto& law : finite_laws()) {
    EXPECT_TRUE(supports(law.material, base::Kinematics::finite));
    EXPECT_EQ(has_history(law.material), law.name.starts_with("j2"));
  }
}

}  // namespace
