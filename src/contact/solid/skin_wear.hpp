#pragma once
#include <concepts>
#include <string_view>
#include <type_traits>
#include <vector>

#include "contact/fields.hpp"
#include "contact/solid/cone.hpp"
#include "contact/solid/skin_place.hpp"
#include "wear/law.hpp"

/// Wear of both sides of a contact between solids, within the equations of its increment.
namespace reye::contact {

/// What evolves in a contact that rubs and wears; a new member is entered in the list below, too. Volumes in mm^3 and
/// work in mJ are stored. The worn depth is what shape steps have moved and `pending` / nodal area on X; it is not
/// `removed` / area, for areas change where faces are curved.
struct SkinWear {
  std::vector<double> pending_secondary, pending_primary;  ///< removed volume per point that is still in the gap
  std::vector<double> removed_secondary, removed_primary;  ///< removed volume per point since the start
  std::vector<double> moved_secondary, moved_primary;      ///< depth per point that shape steps have moved [mm]
  /// Opening of the gap per secondary point [mm] by what the meshes of worn faces lack: far less than an element, but
  /// not than what bodies yield.
  std::vector<double> fit;
  std::vector<double> slip;      ///< path of slip per secondary point since the start [mm]
  std::vector<double> energy;    ///< frictional work per secondary point since the start
  double frictional_work = 0.0;  ///< all of it, whether wear was on or not, times the jump
  double worn_work = 0.0;        ///< the part that wear acted on
  double law_volume = 0.0;       ///< volume that the law asks for, both sides (wear::Ledger::asked)
  double strip_secondary = 0.0;  ///< volume removed by shape steps, measured as strips
  double strip_primary = 0.0;
};

/// Calls visit(Field, member) for each member of a SkinWear, in the order of the checkpoint.
template <class State, class Visit>
requires std::same_as<std::remove_const_t<State>, SkinWear>
void for_each_field(State& s, Visit visit) {
  using enum Site;
  using enum OnFreshMesh;
  visit(Field{"pending_secondary", secondary, derived, Corrected::wear}, s.pending_secondary);
  visit(Field{"pending_primary", primary, derived, Corrected::wear}, s.pending_primary);
  visit(Field{"removed_secondary", secondary, summed, Corrected::wear}, s.removed_secondary);
  visit(Field{"removed_primary", primary, summed, Corrected::wear}, s.removed_primary);
  visit(Field{"moved_secondary", secondary, interpolated}, s.moved_secondary);
  visit(Field{"moved_primary", primary, interpolated}, s.moved_primary);
  visit(Field{"fit", secondary, interpolated}, s.fit);
  visit(Field{"slip", secondary, interpolated, Corrected::doubled}, s.slip);
  visit(Field{"energy", secondary, summed, Corrected::work}, s.energy);
  visit(Field{"frictional_work", contact, stays, Corrected::doubled}, s.frictional_work);
  visit(Field{"worn_work", contact, stays, Corrected::doubled}, s.worn_work);
  visit(Field{"law_volume", contact, stays, Corrected::doubled}, s.law_volume);
  visit(Field{"strip_secondary", contact, stays}, s.strip_secondary);
  visit(Field{"strip_primary", contact, stays}, s.strip_primary);
  // A member that is added to the struct and not to the list does not compile here.
  [[maybe_unused]] const auto& [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14] = s;
}

/// Nothing worn yet.
SkinWear fresh_wear(const SkinSetup& setup);

/// What an increment asks of the wear of a contact.
struct SkinWearing {
  bool on = false;          ///< the step wears, and so does the contact
  double jump = 1.0;        ///< cycles that the increment stands for
  double duration_s = 0.0;  ///< of the increment in each of them
  double cycle = 0.0;       ///< before the block
  /// Volumes per point that gaps see beside what has been removed; empty: there are none.
  std::vector<double> ahead_secondary{}, ahead_primary{};
};

/// Volumes that a sliding point removes from both sides in an increment, and how they change with its traction z and
/// its relative motion w: dV = of_traction . dz + of_motion . dw.
struct SkinWorn {
  struct Side {
    double volume = 0.0;  ///< [mm^3]
    base::Vec3 of_traction = base::Vec3::Zero(), of_motion = base::Vec3::Zero();
  };
  Side secondary, primary;
  bool any() const { return secondary.volume != 0.0 || primary.volume != 0.0; }
};

/// Work and way of a sliding point, the frictional work z_t . u_t over the covered area, by the law of the contact.
SkinWorn worn_at(const wear::Law& law, const SkinNode& node, const SkinFrame& frame, double covered,
                 const wear::Start& start);

/// How volumes removed at the points open the gaps: per secondary point j, in the weak sense of the multipliers,
///   opening_j = 1 / covered_j (sum_k D_jk d_k + sum_l M_jl d_l),  d = V / A,
/// the volume that point k takes from the primary side spread over its points by T_kl / sum_l T_kl.
class SkinOpenings {
 public:
  SkinOpenings() = default;
  SkinOpenings(const SkinSetup& setup, const SkinPlace& place);

  /// Openings by volumes at the points of both sides [mm].
  base::Vector by_volumes(const std::vector<double>& secondary, const std::vector<double>& primary) const;
  /// Rows over secondary points: gaps opened per volume that a secondary point takes from its own side, or from the
  /// primary side [1/mm^2].
  const SkinRows& per_secondary() const { return per_secondary_; }
  const SkinRows& per_primary() const { return per_primary_; }
  /// The volume that secondary point k takes from the primary side, spread over its points.
  void spread(int k, double volume, std::vector<double>& primary) const;
  /// Worn depth of the primary side at what a secondary point faces [mm].
  double depth_faced(int j, const SkinWear& wear, const base::Vector& area) const;

 private:
  SkinRows per_secondary_, per_primary_;
  SkinRows share_;       ///< T_kl / sum_l T_kl: secondary x primary points
  SkinRows of_primary_;  ///< M_jl / (covered_j A_l)
};

/// Books what a solved increment has removed and dissipated.
void book(const SkinSetup& setup, const SkinPlace& place, const SkinOpenings& openings,
          const std::vector<SkinNode>& nodes, const std::vector<SkinStatus>& status, const std::vector<SkinWorn>& worn,
          const SkinWearing& wearing, SkinWear& wear);

}  // namespace reye::contact
