#pragma once
#include <vector>

#include "contact/interface.hpp"
#include "solver/system.hpp"

namespace reye::solver {

/// The mean length of a facet of a contact's surfaces [mm].
double facet_length(const contact::Setup& setup);

/// Contact nodes that can take part for now; the others are condensed out, exactly.
struct Reach {
  std::vector<std::vector<char>> secondary, primary;  ///< per contact, per surface node: 1 when it may touch

  static Reach all(const System& system);

  /// Number of nodes beyond the contact: a fixed one, plus one for each so many active ones (0: none).
  struct Margin {
    int nodes = 0, active_per_node = 0;
  };
  /// The active nodes, those `ahead` (`Controls`) and those they meet, with a margin on either side. Everything while a
  /// contact has no active node.
  static Reach round_contact(const System& system, const std::vector<contact::ContactState>& contacts, Margin margin,
                             const std::vector<std::vector<char>>& ahead = {});
  static Reach round_contact(const System& system, const std::vector<contact::Interface>& contacts, Margin margin);

  /// The nodes that conditions and forces of active ones depend on or act on, by their derivatives. Of a contact
  /// without active ones: everything.
  static Reach of_derivatives(const std::vector<contact::Interface>& contacts,
                              const std::vector<contact::Linearised>& derivatives);

  Reach widened(const System& system, int nodes) const;
  int nodes() const;                       ///< number of those that may touch
  bool holds(const Reach& smaller) const;  ///< whether all nodes of another reach are of this one
  enum class Bodies { linear, deformable };
  /// Per global column: whether it moves nothing but nodes of these bodies out of reach.
  std::vector<char> columns_out(const System& system, Bodies of) const;

  /// No active node is at the rim of the reach or beside a node there, no met one at the rim, and none beyond it is
  /// overlapped, in a contact integrated on all of its nodes.
  bool encloses(int contact, const contact::Interface& face) const;

  bool operator==(const Reach&) const = default;

 private:
  bool add(const contact::Setup& setup, const std::vector<contact::ContactStatus>& status,
           const std::vector<contact::MortarRow>& rows, Margin margin, const std::vector<char>& ahead = {});
};

}  // namespace reye::solver
