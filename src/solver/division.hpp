#pragma once
#include <utility>
#include <vector>

#include "contact/interface.hpp"

/// The contact that carries a place which several list on their secondary side: a place can meet one other side only.
namespace reye::solver {

/// Places on the secondary side of several contacts: per place, its number in each.
struct SharedSecondary {
  using Places = std::vector<std::pair<int, int>>;  ///< (contact, node or facet of its secondary surface)
  std::vector<Places> nodes, facets;
};

/// The shared places of contacts; bonds give way as a whole (`make_system`).
SharedSecondary shared_secondary(const std::vector<contact::Setup>& contacts);

/// Leaves every node that several contacts meet to the one that covers most of it and is near, and every facet between
/// nodes of two contacts to the one that covers most of it. A node that is active stays where it is until another
/// contact has twice as much: so decisions cannot alternate for ever.   (README, 5)
void divide(const SharedSecondary& shared, std::vector<contact::Interface>& faces);

}  // namespace reye::solver
