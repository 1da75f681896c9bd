#pragma once
#include <Eigen/Core>
#include <array>
#include <type_traits>
#include <variant>

#include "base/analysis.hpp"
#include "base/dual.hpp"
#include "material/material.hpp"
#include "material/parameters.hpp"
#include "material/radial_return.hpp"

/// Stress at small strain, one formula for values and tangents.
namespace reye::material {

/// Strain in thickness of an elastic sheet with the in-plane trace given and sigma_33 = 0: the start of its search.
template <class Law>
Search thickness_search(const Law& m, double plane_trace, const PlasticState& before) {
  const double elastic = plane_trace + before.strain[3];  // the plastic strain has no trace
  const double start = before.strain[3] - elastic * m.nu / (1.0 - m.nu);
  return {.start = start, .low = start - 5.0, .high = start + 5.0};
}

/// Hooke's law, to which every elastic law reduces: sigma = lambda tr(eps) I + 2 mu eps [MPa].
/// Plane stress: eps_33 = -lambda / (lambda + 2 mu) (eps_11 + eps_22).      (1)
template <class Law, class T>
Voigt<T> small_stress(const Law& m, base::Analysis analysis, const Voigt<T>& strain, const PlasticState&,
                      PlasticState*) {
  const double mu = shear_modulus(m), lambda = lame_lambda(m);
  const T plane = strain[0] + strain[1];
  const bool thin = analysis == base::Analysis::plane_stress;
  const T thickness = thin ? T(plane * (-lambda / (lambda + 2.0 * mu))) : strain[3];
  const T pressure = (plane + thickness) * lambda;
  return {pressure + strain[0] * (2.0 * mu), pressure + strain[1] * (2.0 * mu), strain[2] * mu,
          thin ? T(0.0) : T(pressure + thickness * (2.0 * mu))};
}

/// J2 with additive split: radial return from the trial strain eps - eps_p. Plane stress: eps_33 from sigma_33 = 0.
template <class T>
Voigt<T> small_stress(const HenckyJ2& m, base::Analysis analysis, const Voigt<T>& strain, const PlasticState& before,
                      PlasticState* after) {
  const auto returned = [&](const auto& e, const auto& thickness) {
    const auto& p = before.strain;
    const Symmetric<std::decay_t<decltype(thickness)>> trial{e[0] - p[0], e[1] - p[1], e[2] * 0.5 - p[2],
                                                             thickness - p[3]};
    return radial_return(m, trial, before.accumulated);
  };
  T thickness = strain[3];
  if (analysis == base::Analysis::plane_stress) {
    const auto normal = [&](const auto& e, const auto& x) { return returned(e, x).stress[3] * (1.0 / m.E_MPa); };
    const double trace = base::value(strain[0]) + base::value(strain[1]);
    thickness = solved(normal, strain, thickness_search(m, trace, before), "thickness strain for the strain");
  }
  const auto result = returned(strain, thickness);
  if (after) {
    *after = before;
    after->accumulated += result.increment;
    for (int i = 0; i < 4; ++i) after->strain[i] += result.plastic[i];
  }
  return result.stress;
}

/// Stress (11, 22, 12, 33) [MPa] at small strain (11, 22, gamma_12, 33), from the plastic state before the increment;
/// `after`, if given, gets the state at its end (untouched by laws without history).
/// Plane strain and axisymmetric use eps_33 as given; in plane stress it is not read but condensed from sigma_33 = 0.
/// Throws base::SolveError when a local iteration fails.
template <class T>
Voigt<T> stress(const Material& material, base::Analysis analysis, const Voigt<T>& strain,
                const PlasticState& before = {}, PlasticState* after = nullptr) {
  return std::visit([&](const auto& m) { return small_stress(m, analysis, strain, before, after); }, material);
}

/// Tangent C = d sigma / d eps [MPa], rows and columns (11, 22, 12, 33), at a strain; by dual numbers.
inline Eigen::Matrix4d tangent(const Material& material, base::Analysis analysis, const Voigt<double>& strain = {},
                               const PlasticState& before = {}) {
  Voigt<base::Dual<4>> e;
  for (int j = 0; j < 4; ++j) e[j] = base::Dual<4>::variable(strain[j], j);
  const auto s = stress(material, analysis, e, before);
  Eigen::Matrix4d C;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) C(i, j) = s[i].d[j];
  return C;
}

}  // namespace reye::material
