#include "solver/solid/fit_gaps.hpp"

#include "solver/solid/worn_contact.hpp"

namespace reye::solver {

void fit_gaps(const SolidSystem& system, SolidState& state) {
  const Vector x = positions(system, state.u);
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& options = system.contacts[c].options;
    if (!options.wear.wears() || !options.implicit_wear) continue;
    mortar::SkinPairs pairs;
    const auto place = contact::place_skins(system.contacts[c], state.u, system.held, system.points(), pairs);
    const Points3 w = contact::relative(place, x);
    auto& wear = state.wear[c];
    const Vector opened = worn_contact(system.contacts[c], place, wear).opened_before;
    for (int j = 0; j < place.count(); ++j) {
      if (!place.carries[j]) continue;
      const Vec3& normal = place.frame[j].normal;
      const double gap = opened[j] - normal.dot(w[j]);
      const bool presses = state.status[c][j] != contact::SkinStatus::open && state.traction[c][j].dot(normal) > 0.0;
      if (presses || gap < 0.0) wear.fit[j] -= gap;
    }
  }
}

}  // namespace reye::solver
