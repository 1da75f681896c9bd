#pragma once
#include <limits>

#include "material/finite.hpp"

/// The elastic part of a deformation, and the plastic state that leaves it: they carry the state of a point to another
/// mesh, whose deformation differs slightly.
namespace reye::material {

/// The state on which stress and yielding depend: the elastic strain as tensor components (11, 22, 12, 33) on x, at
/// small strain eps - eps_p, at finite strain 1/2 ln b_e, and the accumulated plastic strain p >= 0.
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

/// Elastic state of a strain (11, 22, gamma_12, 33) and the plastic state it was accepted with: eps - eps_p.
inline ElasticState elastic_state(const Material& m, base::Analysis analysis, const Voigt<double>& strain,
                                  const PlasticState& state) {
  const auto& p = state.strain;
  const Symmetric<double> e{strain[0] - p[0], strain[1] - p[1], 0.5 * strain[2] - p[2], strain[3] - p[3]};
  return with_thickness(m, analysis, {e, state.accumulated});
}

/// Elastic state of a deformation gradient: 1/2 ln(F C_p^-1 F^T).
inline ElasticState elastic_state(const Material& m, base::Analysis analysis, const Gradient<double>& F,
                                  const PlasticState& state) {
  const auto twice = logarithm(pushed(F, exponential(scaled(state.strain, -2.0))));
  return with_thickness(m, analysis, {scaled(twice, 0.5), state.accumulated});
}

/// The plastic state with which a strain leaves this elastic one: eps_p = eps - eps_e. Its trace is the volume change
/// of eps beyond that of the elastic strain; in a sheet it is zero, since the thickness is free. eps_e may lie beyond
/// the yield surface: if it were returned to it, plastic strain would arise that p does not count.
inline PlasticState plastic_state(base::Analysis analysis, const Voigt<double>& strain, const ElasticState& elastic) {
  const auto& e = elastic.strain;
  PlasticState s{{strain[0] - e[0], strain[1] - e[1], 0.5 * strain[2] - e[2], strain[3] - e[3]}, elastic.accumulated};
  if (analysis == base::Analysis::plane_stress) s.strain[3] = -(s.strain[0] + s.strain[1]);
  return s;
}

/// Plastic state at a deformation gradient that leaves the elastic one: C_p^-1 = F^-1 exp(2 eps_e) F^-T.
inline PlasticState plastic_state(base::Analysis analysis, const Gradient<double>& F, const ElasticState& elastic) {
  auto s = updated(F, elastic.strain, elastic.accumulated);
  if (analysis == base::Analysis::plane_stress) s.strain[3] = -(s.strain[0] + s.strain[1]);
  return s;
}

/// The material without its yield surface: the response of a plastic body that is only brought to equilibrium, not
/// loaded.
inline Material unyielding(Material material) {
  if (auto* j2 = std::get_if<HenckyJ2>(&material))
    j2->hardening = LinearHardening{std::numeric_limits<double>::infinity(), 0.0};
  return material;
}

}  // namespace reye::material
