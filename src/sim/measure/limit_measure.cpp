#include "sim/measure/limit_measure.hpp"

#include "sim/measure/measure.hpp"
#include "sim/measure/shared_wear.hpp"

namespace reye::sim {

double limit_measure(const scene::Limit& limit, const contact::Setup& setup, const contact::ContactState& state,
                     const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed) {
  const auto c = summarise(setup, state, shapes, placed);
  const auto of = [&](const SideSummary& side) { return limit.depth_mm ? side.max_depth_mm : side.worn_area; };
  if (limit.side == "secondary") return of(c.secondary);
  if (limit.side == "primary") return of(c.primary);
  return of(c.secondary) + of(c.primary);
}

std::map<std::string, double> limit_measures(const Problem& problem, const solver::System& system, const State& state) {
  std::map<std::string, double> measures;
  const auto shown = as_shown(problem, state);
  for (const auto& limit : problem.scene.limits) {
    const auto found = std::find_if(problem.contacts.begin(), problem.contacts.end(),
                                    [&](const auto& c) { return c.options.name == limit.contact; });
    const auto c = static_cast<std::size_t>(found - problem.contacts.begin());
    measures[limit.name] = limit_measure(limit, system.contacts[c], shown[c], state.shapes, *found);
  }
  return measures;
}

}  // namespace reye::sim
