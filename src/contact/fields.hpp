#pragma once
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include "contact/state.hpp"

/// The one list of the quantities of a contact. Fresh states, remeshes, extrapolated blocks, checkpoints and the check
/// of a state that was read loop over it.
namespace reye::contact {

/// The place of a quantity.
enum class Site { secondary, primary, contact };

/// The transfer of a quantity to the nodes of a fresh mesh.
enum class OnFreshMesh {
  stays,         ///< a value of the contact, not of its nodes
  summed,        ///< a nodal share of an integral: its sum stays
  interpolated,  ///< a value at a point
  direction,     ///< interpolated, and of unit length again
  nearest,       ///< a label: that of the nearest node
  derived,       ///< starts afresh: it follows from other quantities, or from the next equilibrium
};

/// The correction of a quantity by a block that was played as a whole and in two halves.
enum class Corrected {
  never,
  wear,     ///< by the correction of its side's removed volume
  work,     ///< by a correction of its own, node by node
  doubled,  ///< x + (x - once), not below zero
};

/// One entry of the list.
struct Field {
  std::string_view name;
  Site site;
  OnFreshMesh on_fresh_mesh;
  Corrected corrected = Corrected::never;
  bool optional = false;  ///< may be empty, where it does not occur
};

/// Calls visit(Field, member) for each member of a ContactState, in the order of the checkpoint; `State` may be const.
template <class State, class Visit>
requires std::same_as<std::remove_const_t<State>, ContactState>
void for_each_field(State& s, Visit visit) {
  using enum Site;
  using enum OnFreshMesh;
  visit(Field{"lambda", secondary, derived}, s.lambda);
  visit(Field{"normal", secondary, direction}, s.normal);
  visit(Field{"status", secondary, nearest}, s.status);
  visit(Field{"reference", secondary, derived}, s.reference);
  visit(Field{"pending_secondary", secondary, derived, Corrected::wear}, s.pending_secondary);
  visit(Field{"pending_primary", primary, derived, Corrected::wear}, s.pending_primary);
  visit(Field{"removed_secondary", secondary, summed, Corrected::wear}, s.removed_secondary);
  visit(Field{"removed_primary", primary, summed, Corrected::wear}, s.removed_primary);
  visit(Field{"others_secondary", secondary, summed, Corrected::never, true}, s.others_secondary);
  visit(Field{"others_primary", primary, summed, Corrected::never, true}, s.others_primary);
  visit(Field{"slip", secondary, interpolated, Corrected::doubled}, s.slip);
  visit(Field{"energy_secondary", secondary, summed, Corrected::work}, s.energy_secondary);
  visit(Field{"nodal_friction", secondary, interpolated, Corrected::never, true}, s.nodal_friction);
  visit(Field{"friction", contact, stays}, s.friction);
  visit(Field{"frictional_work", contact, stays, Corrected::doubled}, s.frictional_work);
  visit(Field{"worn_work", contact, stays, Corrected::doubled}, s.worn_work);
  visit(Field{"law_volume", contact, stays, Corrected::doubled}, s.law_volume);
  visit(Field{"strip_secondary", contact, stays}, s.strip_secondary);
  visit(Field{"strip_primary", contact, stays}, s.strip_primary);
  // A member that is added to the struct and not to the list does not compile here.
  [[maybe_unused]] const auto& [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19] =
      s;
}

/// The members of two states side by side: visit(Field, member of a, member of b).
template <class A, class B, class Visit>
void for_each_field(A& a, B& b, Visit visit) {
  for_each_field(a, [&](const Field& field, auto& of_a) {
    for_each_field(b, [&](const Field& other, auto& of_b) {
      if constexpr (std::same_as<std::remove_cvref_t<decltype(of_a)>, std::remove_cvref_t<decltype(of_b)>>)
        if (field.name == other.name) visit(field, of_a, of_b);
    });
  });
}

/// The initial value of a quantity.
template <class T>
T nothing() {
  if constexpr (std::same_as<T, Vec2>)
    return Vec2::Zero();
  else
    return T{};
}

/// Sets every nodal value to its initial value; optional ones stay empty. `which`: the fields concerned.
template <class Which>
void clear_fields(ContactState& state, std::size_t secondary, std::size_t primary, Which which) {
  for_each_field(state, [&](const Field& field, auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (!std::is_arithmetic_v<Member>)
      if (which(field)) {
        const std::size_t count = field.optional ? 0 : field.site == Site::secondary ? secondary : primary;
        member.assign(count, nothing<typename Member::value_type>());
      }
  });
}

}  // namespace reye::contact
