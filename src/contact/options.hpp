#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/part.hpp"
#include "wear/law.hpp"

namespace reye::contact {

/// Order of the multipliers on facets of second order (on facets of two nodes they are always linear). quadratic: one
/// per node and control point. linear: at the nodes alone, each with a share of the control points beside it.
enum class DualOrder { linear, quadratic };

/// A contact of the scene: one secondary boundary (carries the multipliers) against a list of primary ones.
struct ContactOptions {
  std::string name;
  std::string secondary;
  std::vector<std::string> primary;
  double friction = 0.0;  ///< Coulomb coefficient mu >= 0; of a table its largest value
  /// mu as a formula; `friction` is then its largest value at the start. Empty: a number, or a table.
  wear::Formula friction_formula{};
  std::vector<std::array<double, 2>> friction_over_cycles{};  ///< [cycle, mu], cycles increasing; empty: mu is constant
  wear::Law wear;
  bool imposed = false;       ///< slip is a number, along the contact or out of the plane
  bool out_of_plane = false;  ///< slip is imposed out of the plane: friction acts there and leaves no shear in it
  /// Imposed slip [mm]: a part without history is shared evenly by each play of a step, others go as their histories
  /// are played.
  base::Parts imposed_sliding{};
  base::Parts imposed_turn{};  ///< imposed turn about the axis [rad]: slip = angle x r
  bool bonded = false;         ///< a bond: it neither opens nor slips, and nothing of it wears
  bool implicit_wear = true;   ///< this increment's wear inside the equations
  DualOrder dual = DualOrder::quadratic;
  double search_mm = 0.0;  ///< facing facets farther apart than this are not paired; 0: chosen from the bodies
  double drawn_mm = 0.0;   ///< distance of the sides as drawn: a chosen search covers it
  double c_normal = 1.0;   ///< dimensionless factors of the complementarity functions
  double c_tangential = 1.0;
};

}  // namespace reye::contact
