#pragma once
#include <span>
#include <vector>

#include "contact/solid/cone.hpp"
#include "solver/solid/solid_system.hpp"

namespace reye::solver {

/// Of all changes from `now` to `fresh` those alone whose trial value is beyond its limit by at least half of the
/// largest such excess; the others are taken back. Points that stick and slip in turn, each because of the other,
/// settle then. `friction` per contact.
void keep_the_most_due(const SolidSystem& system, std::span<const contact::SkinPlace> places,
                       const std::vector<std::vector<contact::SkinNode>>& nodes, const std::vector<double>& friction,
                       const std::vector<std::vector<contact::SkinStatus>>& now,
                       std::vector<std::vector<contact::SkinStatus>>& fresh);

}  // namespace reye::solver
