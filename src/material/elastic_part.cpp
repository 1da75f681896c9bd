#include "material/elastic_part.hpp"

#include <limits>

#include "material/finite.hpp"

namespace reye::material {

ElasticState with_thickness(const Material& m, base::Analysis analysis, ElasticState e) {
  if (analysis == base::Analysis::plane_stress)
    e.strain[3] = -(e.strain[0] + e.strain[1]) * poisson(m) / (1.0 - poisson(m));
  return e;
}

ElasticState elastic_state(const Material& m, base::Analysis analysis, const Voigt<double>& strain,
                           const PlasticState& state) {
  const auto& p = state.strain;
  const Symmetric<double> e{strain[0] - p[0], strain[1] - p[1], 0.5 * strain[2] - p[2], strain[3] - p[3]};
  return with_thickness(m, analysis, {e, state.accumulated});
}

ElasticState elastic_state(const Material& m, base::Analysis analysis, const Gradient<double>& F,
                           const PlasticState& state) {
  const auto twice = logarithm(pushed(F, exponential(scaled(state.strain, -2.0))));
  return with_thickness(m, analysis, {scaled(twice, 0.5), state.accumulated});
}

PlasticState plastic_state(base::Analysis analysis, const Voigt<double>& strain, const ElasticState& elastic) {
  const auto& e = elastic.strain;
  PlasticState s{{strain[0] - e[0], strain[1] - e[1], 0.5 * strain[2] - e[2], strain[3] - e[3]}, elastic.accumulated};
  if (analysis == base::Analysis::plane_stress) s.strain[3] = -(s.strain[0] + s.strain[1]);
  return s;
}

PlasticState plastic_state(base::Analysis analysis, const Gradient<double>& F, const ElasticState& elastic) {
  auto s = updated(F, elastic.strain, elastic.accumulated);
  if (analysis == base::Analysis::plane_stress) s.strain[3] = -(s.strain[0] + s.strain[1]);
  return s;
}

Material unyielding(Material material) {
  if (auto* j2 = std::get_if<HenckyJ2>(&material))
    j2->hardening = LinearHardening{std::numeric_limits<double>::infinity(), 0.0};
  return material;
}

}  // namespace reye::material
