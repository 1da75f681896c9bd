#pragma once
#include "base/analysis.hpp"
#include "material/material.hpp"

/// Elastic constants of any law (all are given by E and nu) and the abilities of a law.
namespace reye::material {

/// mu = E / (2 (1 + nu)) [MPa].
template <class Law>
double shear_modulus(const Law& m) {
  return m.E_MPa / (2.0 * (1.0 + m.nu));
}

/// First Lame constant lambda = E nu / ((1 + nu)(1 - 2 nu)) [MPa].
template <class Law>
double lame_lambda(const Law& m) {
  return m.E_MPa * m.nu / ((1.0 + m.nu) * (1.0 - 2.0 * m.nu));
}

/// kappa = E / (3 (1 - 2 nu)) [MPa].
template <class Law>
double bulk_modulus(const Law& m) {
  return m.E_MPa / (3.0 * (1.0 - 2.0 * m.nu));
}

double young(const Material& material);
double poisson(const Material& material);
double shear_modulus(const Material& material);
double bulk_modulus(const Material& material);

/// True if the stress depends on a PlasticState.
bool has_history(const Material& material);

/// Every law works at small strain, all but LinearElastic at finite strain.
bool supports(const Material& material, base::Kinematics kinematics);

}  // namespace reye::material
