#pragma once
#include <vector>

#include "contact/solid/cone.hpp"

namespace reye::solver {

/// Of all changes from `now` to `fresh` those alone that are due by at least half of the largest; the others are taken
/// back. Points that stick and slip in turn, each because of the other, settle then. `due` per contact and point: how
/// far what decides is beyond the limit between the two [MPa].
void keep_the_most_due(const std::vector<std::vector<double>>& due,
                       const std::vector<std::vector<contact::SkinStatus>>& now,
                       std::vector<std::vector<contact::SkinStatus>>& fresh);

}  // namespace reye::solver
