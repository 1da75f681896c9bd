#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <vector>

#include "contact/fields.hpp"
#include "sim/problem/block_wear.hpp"

/// The two-step backward differentiation formula of what contacts wear, whatever the dimension.
namespace reye::sim {

/// With x what a contact has worn, f its rate, h the cycles of a block and w = h / h(n-1):
///
///     x(n+1) = x* + b h f(x(n+1)),   x* = x(n) + s (x(n) - x(n-1)),   s = w^2 / (1 + 2 w),   b = (1 + w) / (1 + 2 w)
///
/// A block begins at x*, beyond its start by a share of what the block before has worn, and is played with b h cycles:
/// once, for an end of second order. Every quantity of a contact is the same sum, so that V = coefficient x work stays
/// exact. Stiff modes, uneven shapes above all, are damped as by the Euler formula; stable for w < 1 + sqrt 2
/// (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, III.5).
struct TwoStep {
  double ratio = 1.0;  ///< w

  constexpr double start() const { return ratio * ratio / (1.0 + 2.0 * ratio); }   ///< s
  constexpr double played() const { return (1.0 + ratio) / (1.0 + 2.0 * ratio); }  ///< b
  double apart() const { return 0.5 * ratio / (1.0 + ratio); }                     ///< `two_halves_apart`
  /// What two halves of the block would differ from it as a whole by: h^2 x'' / 4, from what the blocks have worn.
  double two_halves_apart(double before, double now) const { return apart() * (now - ratio * before); }
};

/// Of the cycles of a block to those of the block before: stability asks for less than 2.41.
inline constexpr double most_ratio = 2.0;

/// The formula for a block of `cycles` after one of `before` (0: none); empty where it does not serve.
std::optional<TwoStep> two_step(double cycles, double before);

/// Whether blocks can continue one another: the wear of every contact is in its gap when pressures are found, and
/// follows smoothly from them, not by a law or friction that depends on what a point has gone through.
template <class Contacts>
bool may_continue(const Contacts& contacts) {
  return std::all_of(contacts.begin(), contacts.end(), [](const auto& contact) {
    const auto& options = contact.options;
    if constexpr (requires { options.friction_formula; })
      if (options.friction_formula) return false;
    return !options.wear.wears() || (options.implicit_wear && !options.wear.has_memory());
  });
}

/// Calls visit(growth, before, after) for each quantity that wears, number by number.
template <class Contact, class Visit>
void for_each_worn(Contact& growth, const Contact& before, const Contact& after, Visit visit) {
  contact::for_each_field(growth, after, [&](const contact::Field& field, auto& g, const auto& now) {
    if (field.corrected == contact::Corrected::never) return;
    contact::for_each_field(before, [&](const contact::Field& other, const auto& was) {
      using Member = std::remove_cvref_t<decltype(now)>;
      if constexpr (std::same_as<std::remove_cvref_t<decltype(was)>, Member>) {
        if (other.name != field.name) return;
        if constexpr (std::same_as<Member, double>) {
          visit(g, was, now);
        } else if constexpr (std::same_as<Member, std::vector<double>>) {
          g.resize(now.size(), 0.0);
          for (std::size_t i = 0; i < now.size(); ++i) visit(g[i], was[i], now[i]);
        }
      }
    });
  });
}

/// Adds what contacts have worn from one state to another.
template <class Contact>
void add_growth(std::vector<Contact>& growth, const std::vector<Contact>& before, const std::vector<Contact>& after) {
  growth.resize(after.size());
  for (std::size_t c = 0; c < after.size(); ++c)
    for_each_worn(growth[c], before[c], after[c], [](double& g, double was, double now) { g += now - was; });
  for (auto& g : growth) {  // what shapes have moved by on the way, as after the first of two halves, waits no more
    g.pending_secondary = g.removed_secondary;
    g.pending_primary = g.removed_primary;
  }
}

/// x*, in place of x(n); false, and some of it is added, where a place would hold less than nothing.
template <class Contact>
bool add_share(std::vector<Contact>& contacts, const std::vector<Contact>& growth, double share) {
  bool possible = true;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    for_each_worn(contacts[c], growth[c], growth[c], [&](double& x, double, double grown) {
      x += share * grown;
      possible &= x >= 0.0;
    });
  return possible;
}

/// Takes the share back from the paths of points that no longer slip: `start` and `begun` of the block, `end` of it.
template <class Contact>
void keep_still(const std::vector<Contact>& start, const std::vector<Contact>& begun, std::vector<Contact>& end) {
  for (std::size_t c = 0; c < end.size(); ++c)
    for (std::size_t j = 0; j < end[c].slip.size(); ++j)
      if (end[c].slip[j] == begun[c].slip[j]) end[c].slip[j] = start[c].slip[j];
}

/// A measure in the middle of a block of h cycles: of the parabola through its values h_before cycles before the start,
/// at the start and at the end.
double half_way(double before, double start, double end, double h_before, double h);

/// Measures in the middle of a block of `cycles`, where known. `last`: the block before; `start`, `end`: their values.
template <class Contact>
std::map<std::string, double> half_way(const BlockWear<Contact>& last, const std::map<std::string, double>& start,
                                       const std::map<std::string, double>& end, double cycles) {
  std::map<std::string, double> middle;
  for (const auto& [name, value] : end) {
    const auto before = last.measures.find(name), now = start.find(name);
    if (before != last.measures.end() && now != start.end())
      middle[name] = half_way(before->second, now->second, value, last.cycles, cycles);
  }
  return middle;
}

}  // namespace reye::sim
