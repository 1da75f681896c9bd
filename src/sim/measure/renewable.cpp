#include "sim/measure/renewable.hpp"

#include <algorithm>

#include "sim/measure/sides.hpp"

namespace reye::sim {

bool can_renew(const Problem& problem, int body) {
  const auto& input = problem.inputs[body];
  const auto wears = [&](const PlacedContact& contact) {
    return contact.options.wear.wears() && lies_on(contact, body);
  };
  const auto on_X = [](const fem::BoundaryLoad& load) { return load.traction_MPa != Vec2::Zero() || load.interval_mm; };
  const auto on_nodes = [](const body::Support& support) { return support.point_mm || support.edge_axes; };
  return !problem.rigid[body] && input.kinematics == base::Kinematics::finite && input.point_loads.empty() &&
         input.body_forces.empty() && std::none_of(problem.contacts.begin(), problem.contacts.end(), wears) &&
         std::none_of(input.boundary_loads.begin(), input.boundary_loads.end(), on_X) &&
         std::none_of(input.supports.begin(), input.supports.end(), on_nodes);
}

}  // namespace reye::sim
