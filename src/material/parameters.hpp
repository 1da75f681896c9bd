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

inline double young(const Material& material) {
  return std::visit([](const auto& m) { return m.E_MPa; }, material);
}
inline double poisson(const Material& material) {
  return std::visit([](const auto& m) { return m.nu; }, material);
}
inline double shear_modulus(const Material& material) {
  return std::visit([](const auto& m) { return shear_modulus(m); }, material);
}
inline double bulk_modulus(const Material& material) {
  return std::visit([](const auto& m) { return bulk_modulus(m); }, material);
}

/// True if the stress depends on a PlasticState.
inline bool has_history(const Material& material) { return std::holds_alternative<HenckyJ2>(material); }

/// Every law works at small strain, all but LinearElastic at finite strain.
inline bool supports(const Material& material, base::Kinematics kinematics) {
  return kinematics == base::Kinematics::small || !std::holds_alternative<LinearElastic>(material);
}

}  // namespace reye::material
