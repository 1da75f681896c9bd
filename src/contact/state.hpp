#pragma once
#include <utility>
#include <vector>

#include "base/linalg.hpp"

namespace reye::contact {

using base::Vec2;

using base::Points;
using base::Vector;

enum class ContactStatus : unsigned char { inactive, stick, slip };

/// One row of the mortar matrices, that of secondary node j.
struct MortarRow {
  double D = 0.0;
  double cover = 0.0;                       ///< int N_j over the covered part, on X whatever the measure
  double covered = 0.0;                     ///< `cover` and that of the nodes in `off`
  std::vector<std::pair<int, double>> off;  ///< (secondary node that carries no multiplier, its share int psi_j N_k)
  std::vector<std::pair<int, double>> M;    ///< (primary node, M_jl)

  /// Length that the node's multiplier acts on: D and the shares of others.
  double carried() const {
    double sum = D;
    for (const auto& [k, share] : off) sum += share;
    return sum;
  }
};

/// The evolving state of a contact; a new member is entered in `fields.hpp`, too. Volumes are stored, depth is derived:
/// `removed` / full nodal length on X. Where the shape evolves, `removed` is measured on it: depth below the unworn
/// outline times that length; the exact volumes are in the ledger.
struct ContactState {
  // Compiled once: every file that holds one would else compile them.
  ContactState();
  ContactState(const ContactState&);
  ContactState(ContactState&&) noexcept;
  ContactState& operator=(const ContactState&);
  ContactState& operator=(ContactState&&) noexcept;
  ~ContactState();

  std::vector<Vec2> lambda;  ///< per secondary node [MPa]; lambda . n > 0 in compression
  std::vector<Vec2> normal;  ///< unit normal per secondary node on x, zero before the first increment
  std::vector<ContactStatus> status;
  std::vector<MortarRow> reference;       ///< D and M of the last accepted state: the slip reference
  std::vector<double> pending_secondary;  ///< removed volume per node that is still in the gap
  std::vector<double> pending_primary;
  std::vector<double> removed_secondary;  ///< removed volume per node since the start
  std::vector<double> removed_primary;
  /// Volume that other contacts have taken off the shape at the node since the start; empty: no other wears this
  /// boundary.
  std::vector<double> others_secondary, others_primary;
  std::vector<double> slip;              ///< path of slip per secondary node since the start [mm]
  std::vector<double> energy_secondary;  ///< frictional work per secondary node since the start [mJ per mm]
  /// mu per secondary node in the last accepted increment; empty: it is the same at all of them.
  std::vector<double> nodal_friction;
  double friction = 0.0;         ///< mu of the last accepted increment; of its nodes the largest
  double frictional_work = 0.0;  ///< all of it, whether wear was on or not [mJ per mm], times the jump
  double worn_work = 0.0;        ///< the part that wear acted on
  double law_volume = 0.0;       ///< volume that the law asks for, both sides (wear::Ledger::asked)
  double strip_secondary = 0.0;  ///< volume removed by shape steps, measured as strips
  double strip_primary = 0.0;
};

}  // namespace reye::contact
