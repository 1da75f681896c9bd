#include "sim/measure/roundness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "material/parameters.hpp"

namespace reye::sim {

namespace {

constexpr double corner_rad =
    0.35;  ///< a surface that turns by more than these 20 degrees in one node has a corner there

}  // namespace

double effective_modulus(const Problem& problem, const PlacedContact& contact) {
  const auto compliance = [&](int body) {
    if (problem.rigid[body]) return 0.0;
    const auto& material = problem.inputs[body].material;
    const double nu = problem.scene.analysis == base::Analysis::plane_stress ? 0.0 : material::poisson(material);
    return (1.0 - nu * nu) / material::young(material);
  };
  double primary = 0.0;
  for (const auto& ref : contact.primary) primary = std::max(primary, compliance(ref.body));
  return 1.0 / (compliance(contact.secondary.body) + primary);
}

std::optional<double> curvature(const mortar::Surface& s, int node) {
  if (s.is_control_point(node)) return std::nullopt;
  int before = s.before[node], after = s.after[node];
  if (before < 0 && after >= 0) before = std::exchange(after, s.after[s.facets[after][1]]);
  if (after < 0 && before >= 0) after = std::exchange(before, s.before[s.facets[before][0]]);
  if (before < 0 || after < 0) return 0.0;  // a single facet
  const auto chord = [&](int f) -> base::Vec2 { return s.X[s.facets[f][1]] - s.X[s.facets[f][0]]; };
  const base::Vec2 a = chord(before), b = chord(after);
  const double turning = std::atan2(base::cross(a, b), a.dot(b));
  if (std::abs(turning) > corner_rad) return std::nullopt;
  return 2.0 * turning / (a.norm() + b.norm());
}

double spacing(const mortar::Surface& s, int node) {
  double longest = 0.0;
  for (int f : {s.before[node], s.after[node]})
    if (f >= 0)
      longest =
          std::max(longest, (s.X[s.facets[f][1]] - s.X[s.facets[f][0]]).norm() / (s.facets[f][2] >= 0 ? 2.0 : 1.0));
  return longest;
}

double sagitta(const mortar::Surface& s, int node) {
  if (s.order == 2) return 0.0;
  const double h = spacing(s, node);
  return h * h * std::abs(curvature(s, node).value_or(0.0)) / 8.0;
}

}  // namespace reye::sim
