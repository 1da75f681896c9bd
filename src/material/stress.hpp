#pragma once
#include <Eigen/Core>
#include <array>
#include <variant>

#include "base/analysis.hpp"
#include "base/dual.hpp"
#include "material/material.hpp"

/// Stress functions, one formula for values and tangents.
namespace reye::material {

/// Components in the order (11, 22, 12, 33); the shear strain is the engineering one, gamma = 2 eps_12.
template <class T>
using Voigt = std::array<T, 4>;

/// Hooke's law: sigma = lambda tr(eps) I + 2 mu eps [MPa], with (11, 22, 12, 33) in and out.
/// Plane strain and axisymmetric use eps_33 as given. In plane stress eps_33 is not read but condensed from
/// sigma_33 = 0: eps_33 = -lambda / (lambda + 2 mu) (eps_11 + eps_22).      (1)
template <class T>
Voigt<T> stress(const LinearElastic& m, base::Analysis analysis, const Voigt<T>& strain) {
  const double mu = m.E_MPa / (2.0 * (1.0 + m.nu));
  const double lambda = m.E_MPa * m.nu / ((1.0 + m.nu) * (1.0 - 2.0 * m.nu));
  const T plane = strain[0] + strain[1];
  const bool thin = analysis == base::Analysis::plane_stress;
  const T thickness = thin ? T(plane * (-lambda / (lambda + 2.0 * mu))) : strain[3];
  const T pressure = (plane + thickness) * lambda;
  return {pressure + strain[0] * (2.0 * mu), pressure + strain[1] * (2.0 * mu), strain[2] * mu,
          thin ? T(0.0) : T(pressure + thickness * (2.0 * mu))};
}

template <class T>
Voigt<T> stress(const Material& material, base::Analysis analysis, const Voigt<T>& strain) {
  return std::visit([&](const auto& m) { return stress(m, analysis, strain); }, material);
}

/// Tangent C = d sigma / d eps [MPa], rows and columns (11, 22, 12, 33), at a strain; by dual numbers.
inline Eigen::Matrix4d tangent(const Material& material, base::Analysis analysis, const Voigt<double>& strain = {}) {
  Voigt<base::Dual<4>> e;
  for (int j = 0; j < 4; ++j) e[j] = base::Dual<4>::variable(strain[j], j);
  const auto s = stress(material, analysis, e);
  Eigen::Matrix4d C;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) C(i, j) = s[i].d[j];
  return C;
}

}  // namespace reye::material
