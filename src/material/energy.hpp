#pragma once
#include <cmath>

#include "material/elastic_part.hpp"
#include "material/finite.hpp"

/// Stored elastic energy per volume of unstressed material [mJ/mm^3].
namespace reye::material {

/// kappa/2 tr(e)^2 + mu |dev e|^2: of Hooke's law, and of the logarithmic strain.
template <class Law>
double quadratic_energy(const Law& m, const Symmetric<double>& e) {
  const double trace = e[0] + e[1] + e[3];
  const double square = e[0] * e[0] + e[1] * e[1] + 2.0 * e[2] * e[2] + e[3] * e[3];
  return 0.5 * lame_lambda(m) * trace * trace + shear_modulus(m) * square;
}

/// lambda/2 tr(E)^2 + mu E : E, E = 1/2 (F^T F - I), from the invariants of b.
inline double energy_of(const StVenantKirchhoff& m, const Symmetric<double>& b, double) {
  return quadratic_energy(m, combined(b, 0.5, -0.5));
}

/// mu/2 (tr b - 3 - 2 ln J) + U(J), or its power form.
inline double energy_of(const NeoHookean& m, const Symmetric<double>& b, double J) {
  const double mu = shear_modulus(m), lambda = lame_lambda(m), stretch = 0.5 * mu * (b[0] + b[1] + b[3] - 3.0);
  const double rest = stretch - mu * std::log(J);
  switch (m.volumetric) {
    case Volumetric::quadratic:
      return rest + 0.5 * lambda * (J - 1.0) * (J - 1.0);
    case Volumetric::mixed:
      return rest + 0.25 * lambda * (J * J - 1.0 - 2.0 * std::log(J));
    case Volumetric::power: {
      const double twice_beta = 2.0 * m.nu / (1.0 - 2.0 * m.nu);
      return twice_beta == 0.0 ? rest : stretch + mu * std::expm1(-twice_beta * std::log(J)) / twice_beta;
    }
    case Volumetric::log_squared:
      break;
  }
  return rest + 0.5 * lambda * std::log(J) * std::log(J);
}

/// Energy of a strain (11, 22, gamma_12, 33).
inline double strain_energy(const Material& m, base::Analysis analysis, const Voigt<double>& strain,
                            const PlasticState& state) {
  const auto e = elastic_state(m, analysis, strain, state).strain;
  return std::visit([&](const auto& law) { return quadratic_energy(law, e); }, m);
}

/// Energy of a deformation gradient; for the Hencky law of sigma, which has none, that of tau. Throws as `kirchhoff`.
inline double strain_energy(const Material& m, base::Analysis analysis, Gradient<double> F, const PlasticState& state) {
  F[4] = thickness_stretch(m, analysis, F, state);
  return std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (requires { energy_of(law, Symmetric<double>{}, 1.0); })
          return energy_of(law, pushed(F, Symmetric<double>{1.0, 1.0, 0.0, 1.0}), plane_determinant(F) * F[4]);
        else
          return quadratic_energy(law, elastic_state(m, analysis, F, state).strain);
      },
      m);
}

}  // namespace reye::material
