#include "sim/measure/correction.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>

#include "contact/fields.hpp"
#include "sim/measure/nodal_depth.hpp"

namespace reye::sim {

namespace {

using contact::ContactState;
using contact::ContactStatus;

/// Secondary nodes that slipped in the cycle played last; where none is known, those that touch.
std::vector<char> slipped(const State& state, std::size_t contact) {
  const auto& now = state.solution.contacts[contact].status;
  std::vector<char> flags(now.size(), 0);
  bool known = false;
  if (state.recall.step == state.step)
    for (const auto& [span, guess] : state.recall.played) {
      known = true;
      for (std::size_t j = 0; j < flags.size(); ++j) flags[j] |= guess.status[contact][j] == ContactStatus::slip;
    }
  if (!known)
    for (std::size_t j = 0; j < flags.size(); ++j) flags[j] = now[j] != ContactStatus::inactive;
  return flags;
}

SidePlays secondary_plays(const Twice& t, const State& halves, std::size_t c) {
  return {t.start.solution.contacts[c].removed_secondary, t.once.solution.contacts[c].removed_secondary,
          t.middle[c].removed_secondary, halves.solution.contacts[c].removed_secondary};
}

SidePlays primary_plays(const Twice& t, const State& halves, std::size_t c) {
  return {t.start.solution.contacts[c].removed_primary, t.once.solution.contacts[c].removed_primary,
          t.middle[c].removed_primary, halves.solution.contacts[c].removed_primary};
}

/// The nodes of both sides of a contact that wore in one play only.
std::array<std::vector<char>, 2> passed_nodes(const Twice& t, const State& end, std::size_t c) {
  const auto secondary = secondary_plays(t, end, c), primary = primary_plays(t, end, c);
  std::array<std::vector<char>, 2> passed{secondary.passed(), primary.passed()};
  const auto before = slipped(t.start, c);
  const auto& halves = end.solution.contacts[c];
  for (std::size_t j = 0; j < before.size(); ++j) {
    const bool slips = halves.slip[j] > t.middle[c].slip[j];
    passed[0][j] |= static_cast<bool>(before[j]) != slips;
    if (!passed[0][j]) continue;
    for (const auto& [l, M] : halves.reference[j].M) passed[1][l] = 1;
  }
  return passed;
}

void add(std::vector<double>& to, const std::vector<double>& d) {
  for (std::size_t j = 0; j < d.size(); ++j) to[j] += d[j];
}

struct Corrections {
  std::vector<double> secondary, primary, energy;
};

/// Corrects one quantity of the halves by the rule of its field.
template <class Member>
void correct(const contact::Field& field, const Corrections& by, const Member& once, Member& end) {
  const auto twice = [](double whole, double& x) { x = std::max(0.0, 2.0 * x - whole); };
  if constexpr (std::same_as<Member, double>) {
    if (field.corrected == contact::Corrected::doubled) twice(once, end);
  } else if constexpr (std::same_as<Member, std::vector<double>>) {
    const bool secondary = field.site == contact::Site::secondary;
    if (field.corrected == contact::Corrected::wear) add(end, secondary ? by.secondary : by.primary);
    if (field.corrected == contact::Corrected::work) add(end, by.energy);
    if (field.corrected == contact::Corrected::doubled)
      for (std::size_t j = 0; j < end.size(); ++j) twice(once[j], end[j]);
  }
}

std::optional<Corrections> corrections(const solver::System& system, const Twice& t, const State& halves,
                                       std::size_t c) {
  const auto passed = passed_nodes(t, halves, c);
  const auto& setup = system.contacts[c];
  const auto secondary = secondary_plays(t, halves, c), primary = primary_plays(t, halves, c);
  const auto &a = t.once.solution.contacts[c], &b = halves.solution.contacts[c];
  const auto here = trust(setup.secondary, passed[0]), there = trust(setup.primary, passed[1]);
  std::vector<double> spent(b.energy_secondary);
  for (std::size_t j = 0; j < spent.size(); ++j) spent[j] -= t.start.solution.contacts[c].energy_secondary[j];
  Corrections result{side_correction(here, secondary.once, secondary.halves, secondary.worn(), b.pending_secondary),
                     side_correction(there, primary.once, primary.halves, primary.worn(), b.pending_primary),
                     side_correction(here, a.energy_secondary, b.energy_secondary, spent, spent)};
  const bool possible = result.secondary.size() == b.removed_secondary.size() &&
                        result.primary.size() == b.removed_primary.size() && result.energy.size() == spent.size();
  return possible ? std::optional(std::move(result)) : std::nullopt;
}

double difference_of(const mortar::Surface& surface, const std::vector<double>& trusted,
                     const std::vector<double>& once, const std::vector<double>& halves) {
  return side_difference(surface.area, trusted, once, halves, deepest(surface, once), deepest(surface, halves));
}

}  // namespace

std::vector<double> trust(const mortar::Surface& surface, const std::vector<char>& passed) {
  std::vector<std::vector<int>> facets;
  for (const auto& [a, b, mid] : surface.facets) {
    facets.push_back({a, b});
    if (mid >= 0) facets.back().push_back(mid);
  }
  return trust_by_distance(facets, passed);
}

double wear_difference(const solver::System& system, const Twice& twice, const State& halves) {
  double difference = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto &a = twice.once.solution.contacts[c], &b = halves.solution.contacts[c];
    const bool corrected = corrections(system, twice, halves, c).has_value();
    const auto passed = passed_nodes(twice, halves, c);
    const auto trusted = [&](const mortar::Surface& surface, const std::vector<char>& flags) {
      return corrected ? trust(surface, flags) : std::vector<double>(flags.size(), 0.0);
    };
    difference = std::max(
        {difference,
         difference_of(setup.secondary, trusted(setup.secondary, passed[0]), a.removed_secondary, b.removed_secondary),
         difference_of(setup.primary, trusted(setup.primary, passed[1]), a.removed_primary, b.removed_primary)});
  }
  return difference;
}

std::optional<double> continued_difference(const solver::System& system, const State& start, const TwoStep& formula,
                                           const State& end) {
  double difference = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto &was = start.solution.contacts[c], &now = end.solution.contacts[c];
    const auto& growth = start.last_wear.contacts[c];
    ContinuedSide secondary(formula, growth.removed_secondary, was.removed_secondary, now.removed_secondary),
        primary(formula, growth.removed_primary, was.removed_primary, now.removed_primary);
    if (!secondary.serves || !primary.serves) return std::nullopt;
    const auto before = slipped(start, c);
    for (std::size_t j = 0; j < before.size(); ++j) {
      const bool slips = now.slip[j] > was.slip[j];
      secondary.passed[j] |= static_cast<bool>(before[j]) != slips;
      if (!secondary.passed[j]) continue;
      for (const auto& [l, M] : now.reference[j].M) primary.passed[l] = 1;
    }
    difference = std::max(
        {difference,
         difference_of(setup.secondary, trust(setup.secondary, secondary.passed), secondary.once,
                       now.removed_secondary),
         difference_of(setup.primary, trust(setup.primary, primary.passed), primary.once, now.removed_primary)});
  }
  return difference;
}

bool slips_throughout(const State& start, const State& end) {
  for (std::size_t c = 0; c < end.solution.contacts.size(); ++c) {
    const auto &before = start.solution.contacts[c], &after = end.solution.contacts[c];
    bool slips = false, slipped = false, sticks = false;
    for (std::size_t j = 0; j < after.slip.size(); ++j) {
      const bool moved = after.slip[j] > before.slip[j];
      slipped |= moved;
      if (after.lambda[j].dot(after.normal[j]) > 0.0) (moved ? slips : sticks) = true;
    }
    if (slipped && (sticks || !slips)) return false;  // unloaded at the end it may have stuck before
  }
  return true;
}

void extrapolate(const solver::System& system, const Twice& twice, State& halves) {
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto found = corrections(system, twice, halves, c);
    if (!found) continue;
    const auto& a = twice.once.solution.contacts[c];
    auto& b = halves.solution.contacts[c];
    contact::for_each_field(
        a, b, [&](const contact::Field& field, const auto& once, auto& end) { correct(field, *found, once, end); });
  }
}

}  // namespace reye::sim
