#pragma once
#include <cmath>

#include "material/finite.hpp"

/// The elastic part of a deformation, and the plastic state that leaves it: how the state of a point goes to a point of
/// another mesh, whose deformation is slightly another.
namespace reye::material {

/// All that stress and yielding depend on: the elastic strain as tensor components (11, 22, 12, 33) on x, at small
/// strain eps - eps_p, at finite strain 1/2 ln b_e, and the accumulated plastic strain p >= 0.
struct ElasticState {
  Symmetric<double> strain{};
  double accumulated = 0.0;
};

/// In a sheet eps_e33 follows from sigma_33 = lambda tr(eps_e) + 2 mu eps_e33 = 0.
inline ElasticState with_thickness(const Material& m, base::Analysis analysis, ElasticState e) {
  if (analysis == base::Analysis::plane_stress)
    e.strain[3] = -(e.strain[0] + e.strain[1]) * poisson(m) / (1.0 - poisson(m));
  return e;
}

/// Of a strain (11, 22, gamma_12, 33) and the plastic state it was accepted with: eps - eps_p.
inline ElasticState elastic_state(const Material& m, base::Analysis analysis, const Voigt<double>& strain,
                                  const PlasticState& state) {
  const auto& p = state.strain;
  const Symmetric<double> e{strain[0] - p[0], strain[1] - p[1], 0.5 * strain[2] - p[2], strain[3] - p[3]};
  return with_thickness(m, analysis, {e, state.accumulated});
}

/// Of a deformation gradient: 1/2 ln(F C_p^-1 F^T).
inline ElasticState elastic_state(const Material& m, base::Analysis analysis, const Gradient<double>& F,
                                  const PlasticState& state) {
  const auto twice = logarithm(pushed(F, exponential(scaled(state.strain, -2.0))));
  return with_thickness(m, analysis, {scaled(twice, 0.5), state.accumulated});
}

/// eps_e with its deviator taken back to the yield surface where it lies outside, 3 mu e > sigma_y(p).
inline Symmetric<double> admissible(const HenckyJ2& m, const ElasticState& state) {
  const auto& e = state.strain;
  const double mean = (e[0] + e[1] + e[3]) / 3.0;
  const Symmetric<double> dev{e[0] - mean, e[1] - mean, e[2], e[3] - mean};
  const double square = dev[0] * dev[0] + dev[1] * dev[1] + 2.0 * dev[2] * dev[2] + dev[3] * dev[3];
  const double size = std::sqrt(2.0 / 3.0 * square);
  const double bound = yield_stress(m.hardening, state.accumulated) / (3.0 * shear_modulus(m));
  return size > bound ? combined(dev, bound / size, mean) : e;
}

/// The plastic state with which a strain leaves this elastic one: eps_p = eps - eps_e. Its trace is what eps has
/// changed volume otherwise than the elastic strain says; in a sheet it has none, for the thickness is free.
inline PlasticState plastic_state(const HenckyJ2& m, base::Analysis analysis, const Voigt<double>& strain,
                                  const ElasticState& elastic) {
  const auto e = admissible(m, elastic);
  PlasticState s{{strain[0] - e[0], strain[1] - e[1], 0.5 * strain[2] - e[2], strain[3] - e[3]}, elastic.accumulated};
  if (analysis == base::Analysis::plane_stress) s.strain[3] = -(s.strain[0] + s.strain[1]);
  return s;
}

/// The same of a deformation gradient: C_p^-1 = F^-1 exp(2 eps_e) F^-T.
inline PlasticState plastic_state(const HenckyJ2& m, base::Analysis analysis, const Gradient<double>& F,
                                  const ElasticState& elastic) {
  auto s = updated(F, admissible(m, elastic), elastic.accumulated);
  if (analysis == base::Analysis::plane_stress) s.strain[3] = -(s.strain[0] + s.strain[1]);
  return s;
}

}  // namespace reye::material
