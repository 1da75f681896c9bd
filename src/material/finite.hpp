#pragma once
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

#include "material/stress.hpp"

/// Stress at finite strain, one formula for values and tangents. Quantities that vanish with the strain are computed
/// from H = F - I, B = b - I and j = J - 1: from F they would be differences of ones, whose rounding is a stress in
/// stiff materials.
namespace reye::material {

/// tau of an isotropic elastic law from B = F F^T - I and j = det F - 1 [MPa].
/// St Venant-Kirchhoff, F S F^T: tau = lambda/2 tr B b + mu (b^2 - b), b^2 - b = B + B^2.      (2)
template <class T>
Symmetric<T> elastic(const StVenantKirchhoff& m, const Symmetric<T>& B, const T&) {
  const double mu = shear_modulus(m), lambda = lame_lambda(m);
  const T f = (B[0] + B[1] + B[3]) * (0.5 * lambda), g = f + mu, shear = B[2] * B[2] * mu;
  return {f + (g + mu * B[0]) * B[0] + shear, f + (g + mu * B[1]) * B[1] + shear, (g + mu * (B[0] + B[1])) * B[2],
          f + (g + mu * B[3]) * B[3]};
}

/// J U'(J), the factor of I beside mu B.      (4)
template <class T>
T spherical(const NeoHookean& m, const T& j) {
  using std::expm1, std::log1p;
  const double mu = shear_modulus(m), lambda = lame_lambda(m);
  switch (m.volumetric) {
    case Volumetric::quadratic:
      return lambda * (j + 1.0) * j;
    case Volumetric::mixed:
      return (0.5 * lambda) * (j + 2.0) * j;
    case Volumetric::power:
      return expm1(T(log1p(j) * (-2.0 * m.nu / (1.0 - 2.0 * m.nu)))) * (-mu);
    case Volumetric::log_squared:
      break;
  }
  return lambda * log1p(j);
}

/// Neo-Hookean: tau = mu B + J U'(J) I.      (3)
template <class T>
Symmetric<T> elastic(const NeoHookean& m, const Symmetric<T>& B, const T& j) {
  return combined(B, T(shear_modulus(m)), spherical(m, j));
}

/// Hencky: tau, or sigma = tau / J, = lambda tr(eps) I + 2 mu eps, eps = 1/2 ln b.      (5)
template <class T>
Symmetric<T> elastic(const Hencky& m, const Symmetric<T>& B, const T& j) {
  const Symmetric<T> twice = logarithm_beyond_unit(B);
  const T scale = m.cauchy ? j + 1.0 : T(1.0);
  const T pressure = (twice[0] + twice[1] + twice[3]) * (0.5 * lame_lambda(m));
  return combined(twice, scale * shear_modulus(m), scale * pressure);
}

/// tau of an elastic law at a whole F = I + H.
template <class Law, class T>
Symmetric<T> finite_stress(const Law& m, const Gradient<T>& H, const PlasticState&, PlasticState* = nullptr) {
  return elastic(m, stretched(H), dilation(H));
}

/// Plastic strain after a step: C_p^-1 = F^-1 exp(2 eps_e) F^-T, E_p = -1/2 ln C_p^-1. Its determinant is that
/// before, because radial return keeps the trace of eps_e.      (6)
inline PlasticState updated(const Gradient<double>& F, const Symmetric<double>& eps_e, double accumulated) {
  const auto metric = pushed(inverse(F), exponential(scaled(eps_e, 2.0)));
  return {.strain = scaled(logarithm(metric), -0.5), .accumulated = accumulated};
}

/// tau of J2 plasticity: radial return from eps_e = 1/2 ln(F exp(-2 E_p) F^T).      (6)
template <class T>
Symmetric<T> finite_stress(const HenckyJ2& m, const Gradient<T>& H, const PlasticState& before,
                           PlasticState* after = nullptr) {
  const auto F = with_unit(H);
  Symmetric<T> trial = stretched(H);
  if (before.strain != Symmetric<double>{}) {
    const auto plastic = pushed(F, combined(exponential(scaled(before.strain, -2.0)), 1.0, -1.0));
    for (int i = 0; i < 4; ++i) trial[i] += plastic[i];
  }
  trial = logarithm_beyond_unit(trial);
  for (T& e : trial) e = e * 0.5;
  const auto result = radial_return(m, trial, before.accumulated);
  if (after && result.increment == 0.0) *after = before;
  if (after && result.increment > 0.0) {
    auto eps_e = lifted<double>(trial);
    for (int i = 0; i < 4; ++i) eps_e[i] -= result.plastic[i];
    *after = updated(lifted<double>(F), eps_e, before.accumulated + result.increment);
  }
  return result.stress;
}

template <class T>
Symmetric<T> finite_stress(const LinearElastic&, const Gradient<T>&, const PlasticState&, PlasticState* = nullptr) {
  throw std::logic_error("linear elasticity is a law of small strain");
}

/// Throws base::SolveError unless the in-plane determinant and F33 (not read in plane stress) are positive and finite.
inline void check_regular(base::Analysis analysis, const Gradient<double>& F) {
  const double plane = plane_determinant(F), thickness = analysis == base::Analysis::plane_stress ? 1.0 : F[4];
  if (plane > 0.0 && thickness > 0.0 && std::isfinite(plane * thickness)) return;
  throw base::SolveError("the deformation gradient has determinant " + std::to_string(plane) + " in the plane and " +
                         std::to_string(thickness) + " across it");
}

/// H33 of plane stress, from tau_33 = 0, of a law at an in-plane H; H33 as given is not read.
/// Throws base::SolveError when it does not exist (St Venant-Kirchhoff stretched far).
template <class Law, class T>
T condensed_stretch(const Law& m, const Gradient<T>& H, const PlasticState& before) {
  using std::expm1;
  const auto normal = [&](auto G, const auto& log_stretch) {
    G[4] = expm1(log_stretch);
    return finite_stress(m, G, before)[3] * (1.0 / m.E_MPa);
  };
  const double trace = std::log1p(base::value(plane_dilation(H)));
  const Search search = thickness_search(m, trace, before);
  return expm1(solved(normal, H, search, "thickness stretch for the displacement gradient"));
}

/// Kirchhoff stress tau = J sigma (11, 22, 12, 33) [MPa] at F = I + H, from the plastic state before the increment;
/// `after`, if given, gets the state at its end (untouched by laws without history).
/// Plane strain and axisymmetric use F33 as given; in plane stress it is not read but condensed from tau_33 = 0.
/// Throws base::SolveError when F is not a regular deformation, a local iteration fails or the stress is not finite;
/// std::logic_error for a law without finite strain (`supports`).
template <class T>
Voigt<T> kirchhoff_from(const Material& material, base::Analysis analysis, const Gradient<T>& H,
                        const PlasticState& before = {}, PlasticState* after = nullptr) {
  check_regular(analysis, with_unit(lifted<double>(H)));
  const auto at = [&](const auto& m) {
    auto G = H;
    if (analysis == base::Analysis::plane_stress) G[4] = condensed_stretch(m, H, before);
    return finite_stress(m, G, before, after);
  };
  const Voigt<T> tau = std::visit(at, material);
  for (const T& t : tau)
    if (!std::isfinite(base::value(t))) throw base::SolveError("the stress is not finite");
  return tau;
}

/// First Piola-Kirchhoff stress P = tau F^-T (11, 12, 21, 22, 33) [MPa], work conjugate to F component by component.
/// Arguments and errors as `kirchhoff_from`; in plane stress P33 = 0.
template <class T>
Gradient<T> first_piola_from(const Material& material, base::Analysis analysis, const Gradient<T>& H,
                             const PlasticState& before = {}, PlasticState* after = nullptr) {
  const Voigt<T> tau = kirchhoff_from(material, analysis, H, before, after);
  const Gradient<T> F = with_unit(H);
  const T f = 1.0 / plane_determinant(F);
  const bool thin = analysis == base::Analysis::plane_stress;
  return {(tau[0] * F[3] - tau[2] * F[1]) * f, (tau[2] * F[0] - tau[0] * F[2]) * f, (tau[2] * F[3] - tau[1] * F[1]) * f,
          (tau[1] * F[0] - tau[2] * F[2]) * f, thin ? T(0.0) : T(tau[3] / F[4])};
}

/// Kirchhoff stress from F.
template <class T>
Voigt<T> kirchhoff(const Material& material, base::Analysis analysis, const Gradient<T>& F,
                   const PlasticState& before = {}, PlasticState* after = nullptr) {
  return kirchhoff_from(material, analysis, without_unit(F), before, after);
}
template <class T>
Gradient<T> first_piola(const Material& material, base::Analysis analysis, const Gradient<T>& F,
                        const PlasticState& before = {}, PlasticState* after = nullptr) {
  return first_piola_from(material, analysis, without_unit(F), before, after);
}

/// F33 at F: as given, or in plane stress the one that makes tau_33 = 0; with it sigma = tau / J.
template <class T>
T thickness_stretch(const Material& material, base::Analysis analysis, const Gradient<T>& F,
                    const PlasticState& before = {}) {
  if (analysis != base::Analysis::plane_stress) return F[4];
  check_regular(analysis, lifted<double>(F));
  return std::visit([&](const auto& m) { return T(condensed_stretch(m, without_unit(F), before) + 1.0); }, material);
}

}  // namespace reye::material
