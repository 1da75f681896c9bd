#include "sim/solid/solid_correction.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/measure/side_correction.hpp"
#include "sim/solid/skin_depth.hpp"

namespace reye::sim {

namespace {

using contact::SkinWear;

/// The plays of both sides of a contact.
struct SkinPlays {
  SidePlays secondary, primary;
};

SkinPlays skin_plays(const SolidTwice& t, const SolidRunState& halves, std::size_t c) {
  const auto &start = t.start.solution.wear[c], &once = t.once.solution.wear[c], &middle = t.middle[c],
             &end = halves.solution.wear[c];
  return {{start.removed_secondary, once.removed_secondary, middle.removed_secondary, end.removed_secondary},
          {start.removed_primary, once.removed_primary, middle.removed_primary, end.removed_primary}};
}

std::vector<double> trust_in(const contact::SkinSide& side, const std::vector<char>& passed) {
  std::vector<std::span<const int>> facets;
  for (const auto& facet : side.skin.facets)
    facets.emplace_back(facet.nodes.data(), static_cast<std::size_t>(facet.count()));
  return trust_by_distance(facets, passed);
}

/// How far the points of both sides are trusted: those near to where wear, or sliding, began or ended are not.
struct SkinTrust {
  std::vector<double> secondary, primary;
};

SkinTrust skin_trust(const solver::SolidSystem& system, const SolidTwice& t, const SolidRunState& halves,
                     std::size_t c) {
  const auto plays = skin_plays(t, halves, c);
  auto here = plays.secondary.passed();
  const auto slid = slid_between(t.middle, halves.solution.wear);
  const bool known = std::any_of(t.start.slid[c].begin(), t.start.slid[c].end(), [](char s) { return s != 0; });
  for (std::size_t j = 0; j < here.size() && known; ++j) here[j] |= t.start.slid[c][j] != slid[c][j];
  return {trust_in(system.contacts[c].secondary, here), trust_in(system.contacts[c].primary, plays.primary.passed())};
}

struct SkinCorrections {
  std::vector<double> secondary, primary, energy;
};

std::optional<SkinCorrections> skin_corrections(const SolidTwice& t, const SolidRunState& halves,
                                                const SkinTrust& trust, std::size_t c) {
  const auto plays = skin_plays(t, halves, c);
  const auto &a = t.once.solution.wear[c], &b = halves.solution.wear[c];
  std::vector<double> spent(b.energy);
  for (std::size_t j = 0; j < spent.size(); ++j) spent[j] -= t.start.solution.wear[c].energy[j];
  SkinCorrections result{
      side_correction(trust.secondary, plays.secondary.once, plays.secondary.halves, plays.secondary.worn(),
                      b.pending_secondary),
      side_correction(trust.primary, plays.primary.once, plays.primary.halves, plays.primary.worn(), b.pending_primary),
      side_correction(trust.secondary, a.energy, b.energy, spent, spent)};
  const bool possible = result.secondary.size() == b.removed_secondary.size() &&
                        result.primary.size() == b.removed_primary.size() && result.energy.size() == spent.size();
  return possible ? std::optional(std::move(result)) : std::nullopt;
}

void add_to(std::vector<double>& to, const std::vector<double>& d) {
  for (std::size_t j = 0; j < d.size(); ++j) to[j] += d[j];
}

/// Corrects one quantity of the halves by the rule of its field.
template <class Member>
void correct_field(const contact::Field& field, const SkinCorrections& by, const Member& once, Member& end) {
  const auto twice = [](double whole, double& x) { x = std::max(0.0, 2.0 * x - whole); };
  if constexpr (std::is_arithmetic_v<Member>) {
    if (field.corrected == contact::Corrected::doubled) twice(once, end);
  } else {
    if (field.corrected == contact::Corrected::wear)
      add_to(end, field.site == contact::Site::secondary ? by.secondary : by.primary);
    if (field.corrected == contact::Corrected::work) add_to(end, by.energy);
    if (field.corrected == contact::Corrected::doubled)
      for (std::size_t j = 0; j < end.size(); ++j) twice(once[j], end[j]);
  }
}

double skin_side_difference(const contact::SkinSide& side, const std::vector<double>& trusted, const SidePlays& plays) {
  return side_difference(point_areas(side), trusted, plays.once, plays.halves, deepest_of(side, plays.once),
                         deepest_of(side, plays.halves));
}

}  // namespace

std::vector<std::vector<char>> slid_between(const std::vector<SkinWear>& before, const std::vector<SkinWear>& after) {
  std::vector<std::vector<char>> slid;
  for (std::size_t c = 0; c < after.size(); ++c) {
    auto& flags = slid.emplace_back(after[c].slip.size(), 0);
    for (std::size_t j = 0; j < flags.size(); ++j) flags[j] = after[c].slip[j] > before[c].slip[j];
  }
  return slid;
}

double skin_wear_difference(const solver::SolidSystem& system, const SolidTwice& twice, const SolidRunState& halves) {
  double difference = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    auto trust = skin_trust(system, twice, halves, c);
    if (!skin_corrections(twice, halves, trust, c)) {
      trust.secondary.assign(trust.secondary.size(), 0.0);
      trust.primary.assign(trust.primary.size(), 0.0);
    }
    const auto plays = skin_plays(twice, halves, c);
    difference =
        std::max({difference, skin_side_difference(system.contacts[c].secondary, trust.secondary, plays.secondary),
                  skin_side_difference(system.contacts[c].primary, trust.primary, plays.primary)});
  }
  return difference;
}

std::optional<double> continued_skin_difference(const solver::SolidSystem& system, const SolidRunState& start,
                                                const TwoStep& formula, const SolidRunState& end) {
  const auto slid = slid_between(start.solution.wear, end.solution.wear);
  double difference = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto &was = start.solution.wear[c], &now = end.solution.wear[c], &growth = start.last_wear.contacts[c];
    ContinuedSide secondary(formula, growth.removed_secondary, was.removed_secondary, now.removed_secondary);
    const ContinuedSide primary(formula, growth.removed_primary, was.removed_primary, now.removed_primary);
    if (!secondary.serves || !primary.serves) return std::nullopt;
    for (std::size_t j = 0; j < secondary.passed.size(); ++j) secondary.passed[j] |= start.slid[c][j] != slid[c][j];
    const auto of_side = [](const contact::SkinSide& side, const ContinuedSide& continued,
                            const std::vector<double>& end_of_it) {
      return side_difference(point_areas(side), trust_in(side, continued.passed), continued.once, end_of_it,
                             deepest_of(side, continued.once), deepest_of(side, end_of_it));
    };
    difference = std::max({difference, of_side(setup.secondary, secondary, now.removed_secondary),
                           of_side(setup.primary, primary, now.removed_primary)});
  }
  return difference;
}

bool slides_throughout(const SolidRunState& start, const SolidRunState& end) {
  const auto slid = slid_between(start.solution.wear, end.solution.wear);
  for (std::size_t c = 0; c < slid.size(); ++c) {
    bool slides = false, sticks = false;
    for (std::size_t j = 0; j < slid[c].size(); ++j)
      if (end.solution.status[c][j] != contact::SkinStatus::open) (slid[c][j] ? slides : sticks) = true;
    const bool any = std::any_of(slid[c].begin(), slid[c].end(), [](char s) { return s != 0; });
    if (any && (sticks || !slides)) return false;
  }
  return true;
}

void extrapolate_skins(const solver::SolidSystem& system, const SolidTwice& twice, SolidRunState& halves) {
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto found = skin_corrections(twice, halves, skin_trust(system, twice, halves, c), c);
    if (!found) continue;
    contact::for_each_field(
        twice.once.solution.wear[c], halves.solution.wear[c],
        [&](const contact::Field& field, const auto& once, auto& end) { correct_field(field, *found, once, end); });
  }
}

}  // namespace reye::sim
