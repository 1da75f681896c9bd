#include <Eigen/Eigenvalues>

#include "material/energy.hpp"
#include "material/laws.hpp"

namespace {

using namespace reye;
using namespace reye::material;
using namespace reye::material::test;
using base::Analysis;

/// Stored energy per volume of X, written from the invariants alone.
double energy(const StVenantKirchhoff&, const Tensor& F) {
  const Tensor strain = 0.5 * (F.transpose() * F - Tensor::Identity());
  return lambda / 2 * std::pow(strain.trace(), 2) + mu * strain.squaredNorm();
}
double energy(const Hencky&, const Tensor& F) {
  const Eigen::SelfAdjointEigenSolver<Tensor> C(F.transpose() * F);
  const Eigen::Vector3d e = 0.5 * C.eigenvalues().array().log();
  return lambda / 2 * std::pow(e.sum(), 2) + mu * e.squaredNorm();
}
double energy(const NeoHookean& law, const Tensor& F) {
  const double I1 = F.squaredNorm(), J = F.determinant(), beta = nu / (1 - 2 * nu);
  const double isochoric = mu / 2 * (I1 - 3 - 2 * std::log(J));
  switch (law.volumetric) {
    case Volumetric::log_squared:
      return isochoric + lambda / 2 * std::pow(std::log(J), 2);
    case Volumetric::quadratic:
      return isochoric + lambda / 2 * std::pow(J - 1, 2);
    case Volumetric::mixed:
      return isochoric + lambda / 4 * (J * J - 1 - 2 * std::log(J));
    case Volumetric::power:
      break;
  }
  return mu / 2 * (I1 - 3) + mu / (2 * beta) * (std::pow(J, -2 * beta) - 1);
}
double energy(const LinearElastic&, const Tensor&) { return std::nan(""); }
double energy(const HenckyJ2&, const Tensor&) { return std::nan(""); }

double energy(const Material& material, Analysis analysis, Gradient<double> F) {
  F[4] = thickness_stretch(material, analysis, F);
  return std::visit([&](const auto& law) { return energy(law, tensor(F)); }, material);
}

class Hyperelastic : public testing::TestWithParam<Named> {};
INSTANTIATE_TEST_SUITE_P(all, Hyperelastic, testing::ValuesIn(hyperelastic_laws()), name_of);

// P must be the derivative of the stored energy: central differences of psi approach it at rate 2, sheets included.
TEST_P(Hyperelastic, stress_is_the_derivative_of_the_energy) {
  const auto& material = GetParam().material;
  const Gradient<double> F{1.2, 0.3, -0.2, 0.9, 1.1};
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress}) {
    const auto P = first_piola(material, analysis, F);
    const auto error = [&](double h) {
      double square = 0.0;
      for (int i = 0; i < 5; ++i) {
        auto plus = F, minus = F;
        plus[i] += h, minus[i] -= h;
        const double slope = (energy(material, analysis, plus) - energy(material, analysis, minus)) / (2 * h);
        square += std::pow(slope - P[i], 2);
      }
      return std::sqrt(square);
    };
    EXPECT_LT(error(1e-4), 1e-6 * E);
    EXPECT_NEAR(std::log10(error(1e-2) / error(1e-3)), 2.0, 0.05);
  }
}

// The stored energy that the bodies report must be that of the invariants, sheets included.
TEST_P(Hyperelastic, reported_energy) {
  const auto& material = GetParam().material;
  const Gradient<double> F{1.2, 0.3, -0.2, 0.9, 1.1};
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress})
    EXPECT_NEAR(strain_energy(material, analysis, F, {}) / energy(material, analysis, F), 1.0, 1e-12);
}

}  // namespace
