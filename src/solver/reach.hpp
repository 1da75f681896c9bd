#pragma once
#include <vector>

#include "contact/interface.hpp"
#include "solver/system.hpp"

namespace reye::solver {

/// Contact nodes that can take part for now; the others are condensed out, exactly.
struct Reach {
  std::vector<std::vector<char>> secondary, primary;  ///< per contact, per surface node: 1 when it may touch

  static Reach all(const System& system);

  /// The nodes that were active in `state` and what they met, with a margin of `margin` nodes and of a
  /// quarter of the active ones on either side. Everything while nothing is in contact yet.
  static Reach round_contact(const System& system, const std::vector<contact::ContactState>& contacts, int margin);

  /// No node at the rim of the reach is active or met, and none beyond it is overlapped, in a contact integrated on all
  /// of its nodes.
  bool encloses(int contact, const contact::Interface& face) const;

  bool operator==(const Reach&) const = default;
};

}  // namespace reye::solver
