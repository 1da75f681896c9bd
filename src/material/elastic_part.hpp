#pragma once
#include "base/analysis.hpp"
#include "material/material.hpp"
#include "material/tensor.hpp"

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
ElasticState with_thickness(const Material& m, base::Analysis analysis, ElasticState e);

/// Elastic state of a strain (11, 22, gamma_12, 33) and the plastic state it was accepted with: eps - eps_p.
ElasticState elastic_state(const Material& m, base::Analysis analysis, const Voigt<double>& strain,
                           const PlasticState& state);

/// Elastic state of a deformation gradient: 1/2 ln(F C_p^-1 F^T).
ElasticState elastic_state(const Material& m, base::Analysis analysis, const Gradient<double>& F,
                           const PlasticState& state);

/// The plastic state with which a strain leaves this elastic one: eps_p = eps - eps_e. Its trace is the volume change
/// of eps beyond that of the elastic strain; in a sheet it is zero, since the thickness is free. eps_e may lie beyond
/// the yield surface: if it were returned to it, plastic strain would arise that p does not count.
PlasticState plastic_state(base::Analysis analysis, const Voigt<double>& strain, const ElasticState& elastic);

/// Plastic state at a deformation gradient that leaves the elastic one: C_p^-1 = F^-1 exp(2 eps_e) F^-T.
PlasticState plastic_state(base::Analysis analysis, const Gradient<double>& F, const ElasticState& elastic);

/// The material without its yield surface: the response of a plastic body that is only brought to equilibrium, not
/// loaded.
Material unyielding(Material material);

}  // namespace reye::material
