#pragma once
#include <string>
#include <vector>

#include "sim/place/resolver.hpp"
#include "sim/problem/problem.hpp"

namespace reye::sim {

/// Places the contacts or the bonds of a scene, `kind` being their table: `joints` receives those whose sides are
/// found.
void place_joints(Problem& p, const std::string& kind, const std::vector<contact::ContactOptions>& named,
                  Resolver& resolve, std::vector<PlacedContact>& joints);

}  // namespace reye::sim
